#pragma once
/// What part of the ground a map shows, and its relief as a picture.
#include <cstdint>
#include <string>

#include "study/compare/comparison.hpp"
#include "terrain/relief.hpp"

namespace clast::report_detail {

/// Releases, stops, barriers and measured stops with a margin, neither too long nor too thin; map
/// coordinates. Of a plan (no groups) the whole terrain.
Window map_window(const Comparison& comparison);

/// Where a barrier is marked, and which way crossings count (unit), both on the map.
struct CountArrow {
  Vec2 root = Vec2::Zero();
  Vec2 way = Vec2::UnitX();
  bool both_ways = false;
};
/// On the middle of the line's middle segment.
CountArrow count_arrow(const BarrierLine& line);

/// Metres between contours: about a dozen over the heights the runs pass.
double contour_interval(const Comparison& comparison);

/// Relief of the first file's terrain with contours and zone tints, as "data:image/png;base64,...".
std::string relief_image(const Comparison& comparison, const Window& window, std::uint32_t columns,
                         double interval);

}  // namespace clast::report_detail
