#pragma once
/// Marks of blocks and stops in maps and diagrams, drawn singly or as a density.
#include <array>
#include <span>
#include <string>

#include "core/types.hpp"

namespace clast::report_detail {

/// Draws the mark of a block in the colour of its shape class: a circle if compact, otherwise a
/// diamond.
/// @param x, y  position, positions, px
/// @param filled  true if the inside has the colour; false if it is white
/// @param attributes  attributes of the SVG element, such as its class
/// @param title  tooltip; empty for none
std::string draw_shape_mark(double x, double y, const std::string& garcia, bool filled,
                            const std::string& attributes, const std::string& title);

/// Colours of densities, from low to high.
inline constexpr std::array<const char*, 5> kDensityColours = {"#fcbba1", "#fb6a4a", "#de2d26",
                                                               "#a50f15", "#4a0008"};

/// Draws a density of points: squares coloured by the number of points in them.
/// @param places  px
/// @param corner  corner of one of the squares, px
/// @param noun  name of the counted items in the tooltip, such as "stops"
std::string draw_density_squares(std::span<const Vec2> places, const Vec2& corner,
                                 const std::string& noun);

}  // namespace clast::report_detail
