#pragma once
/// What maps and their legends draw alike.
#include <cstdint>
#include <string>

#include "report/maps/site_map.hpp"

namespace clast::report_detail {

inline constexpr double kMapLeft = 88.0;  ///< of the map in its picture, px
inline constexpr double kMapTop = 12.0;
inline constexpr const char* kMapText = "font-size=\"12\" fill=\"#33404d\"";

/// The part of the plan that is drawn (map coordinates) and where it lies on the picture.
struct Sheet {
  PlanWindow window;
  double scale = 1.0;  ///< px/m

  double width() const { return window.size().x() * scale; }
  double height() const { return window.size().y() * scale; }
  double x(double map_x) const { return kMapLeft + (map_x - window.low.x()) * scale; }
  double y(double map_y) const { return kMapTop + (window.high.y() - map_y) * scale; }
};

/// Cross with a white edge, in px.
std::string draw_release_mark(double x, double y, const std::string& title);

/// Dashed outline with a white edge.
/// @param path  of SVG, closed, px
std::string draw_release_outline(const std::string& path, const std::string& title);

/// Where a barrier is marked, and which way crossings count (unit), both on the map.
struct CountArrow {
  Vec2 root = Vec2::Zero();
  Vec2 way = Vec2::UnitX();
  bool both_ways = false;
};
/// On the middle of the line's middle segment.
CountArrow make_count_arrow(const BarrierLine& line);

/// Relief of the site's window with contours and zone tints, as "data:image/png;base64,...".
std::string draw_relief_image(const SiteMap& site, std::uint32_t columns);

}  // namespace clast::report_detail
