#pragma once
/// What the map of a page draws over the relief, as traces of plotly.js.
#include <nlohmann/json.hpp>

#include "report/maps/site_map.hpp"

namespace clast::report_detail {

/// `meta` of the traces that give way to a raster.
inline constexpr const char* kStopsTrace = "stops";

/// Where runs stop, one by one or as a density, and stops observed in the field.
void add_stops(const Comparison& comparison, const PlanWindow& window, nlohmann::ordered_json& traces);
/// Lines, and in `notes` their names with an arrow the way that counts from the middle of each.
void add_barriers(const SiteMap& site, nlohmann::ordered_json& traces,
                  nlohmann::ordered_json& notes);
void add_releases(const SiteMap& site, nlohmann::ordered_json& traces);
/// Zones as empty entries of the legend.
void add_zones(const SiteMap& site, nlohmann::ordered_json& traces);

}  // namespace clast::report_detail
