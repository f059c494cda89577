#pragma once
/// What the map and its legend draw alike.
#include <string>

#include "terrain/relief.hpp"

namespace clast::report_detail {

inline constexpr double kMapLeft = 88.0;  ///< of the map in its picture, px
inline constexpr double kMapTop = 12.0;
inline constexpr const char* kMapText = "font-size=\"12\" fill=\"#33404d\"";

/// The part of the plan that is drawn (map coordinates) and where it lies on the picture.
struct Sheet {
  Window window;
  double scale = 1.0;  ///< px/m

  double width() const { return window.size().x() * scale; }
  double height() const { return window.size().y() * scale; }
  double x(double map_x) const { return kMapLeft + (map_x - window.low.x()) * scale; }
  double y(double map_y) const { return kMapTop + (window.high.y() - map_y) * scale; }
};

/// Cross with a white edge, in px.
std::string release_mark(double x, double y, const std::string& title);

/// Dashed outline with a white edge.
/// @param path  of SVG, closed, px
std::string release_outline(const std::string& path, const std::string& title);

}  // namespace clast::report_detail
