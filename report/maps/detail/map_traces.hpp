#pragma once
/// Plotly traces that an interactive map draws over the relief.
#include <nlohmann/json.hpp>

#include "report/maps/site_map.hpp"

namespace clast::report_detail {

/// Value of `meta` of traces that are hidden while a raster is shown.
inline constexpr const char* kStopsTraceName = "stops";

/// Adds simulated stops, drawn singly or as a density, and observed stops.
void add_stop_traces(const Comparison& comparison, const PlanWindow& window,
                     nlohmann::ordered_json& traces);
/// Adds barrier lines. Adds their names, with an arrow in the counted direction, to `notes`.
void add_barrier_traces(const SiteMap& site, nlohmann::ordered_json& traces,
                        nlohmann::ordered_json& notes);
void add_release_traces(const SiteMap& site, nlohmann::ordered_json& traces);
/// Adds ground zones as legend entries.
void add_zone_traces(const SiteMap& site, nlohmann::ordered_json& traces);

}  // namespace clast::report_detail
