#pragma once
/// Plotly traces that an interactive map draws over the relief.
#include <nlohmann/json.hpp>

#include "report/maps/site_map.hpp"

namespace clast::report_detail {

/// Value of `meta` for traces of stops. The script of the map hides them while a raster is shown.
inline constexpr const char* kStopsTraceName = "stops";

/// Adds the traces of simulated stops, drawn singly or as a density, and of observed stops.
void add_stop_traces(const Comparison& comparison, const PlanWindow& window,
                     nlohmann::ordered_json& traces);
/// Adds the traces of barrier lines. Their names and arrows of the counted direction are added to
/// `notes`.
void add_barrier_traces(const SiteMap& site, nlohmann::ordered_json& traces,
                        nlohmann::ordered_json& notes);
void add_release_traces(const SiteMap& site, nlohmann::ordered_json& traces);
/// Adds legend entries of the ground zones.
void add_zone_traces(const SiteMap& site, nlohmann::ordered_json& traces);

}  // namespace clast::report_detail
