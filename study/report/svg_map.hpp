#pragma once
/// The map of a report: relief, zones, release points, barriers and stops in map coordinates.
#include <string>

#include "study/comparison.hpp"

namespace clast {

/// More stops than this are drawn as a density, not one by one.
inline constexpr std::size_t kMostSingleStops = 5000;

/// An SVG element with legend, scale bar and north arrow. The relief is that of the first file.
std::string svg_map(const Comparison& comparison);

}  // namespace clast
