#pragma once
/// Marks shared by maps and their legends.
#include <cstdint>
#include <string>

#include "report/maps/site_map.hpp"

namespace clast::report_detail {

inline constexpr double kMapLeft = 88.0;  ///< left edge of the map in the image, px
inline constexpr double kMapTop = 12.0;
inline constexpr const char* kMapTextStyle = "font-size=\"12\" fill=\"#33404d\"";

/// Transformation from a plan window (map coordinates) to image pixels.
struct MapToPixels {
  PlanWindow window;
  double scale = 1.0;  ///< px/m

  double width() const { return window.size().x() * scale; }
  double height() const { return window.size().y() * scale; }
  double x(double map_x) const { return kMapLeft + (map_x - window.low.x()) * scale; }
  double y(double map_y) const { return kMapTop + (window.high.y() - map_y) * scale; }
};

/// Draws the mark of a release point: a cross with a white outline.
std::string draw_release_mark(double x, double y, const std::string& title);

/// Draws the outline of a simultaneous release of blocks as a dashed line.
/// @param path  closed SVG path, px
std::string draw_release_outline(const std::string& path, const std::string& title);

/// Arrow at a barrier in the direction in which crossings are counted, in map coordinates.
struct CountedDirectionArrow {
  Vec2 root = Vec2::Zero();
  Vec2 way = Vec2::UnitX();
  bool both_directions = false;
};
/// Places the arrow of the counted direction on the middle segment of a barrier.
CountedDirectionArrow make_counted_direction_arrow(const BarrierLine& line);

/// Draws the relief of a site with contours and zone colours, as a PNG in a data URL.
std::string draw_relief_image(const SiteMap& site, std::uint32_t columns);

}  // namespace clast::report_detail
