#pragma once
/// The marks that stand for blocks and stops in maps and diagrams, one by one or as a density.
#include <array>
#include <span>
#include <string>

#include "core/types.hpp"

namespace clast::report_detail {

/// Circle for compact, diamond for the rest, about 8 px across, in the colour of its class.
/// @param x, y        px
/// @param filled      else white inside
/// @param attributes  of the element, for example its class
/// @param title       shown when the pointer rests on it; none when empty
std::string draw_shape_mark(double x, double y, const std::string& garcia, bool filled,
                       const std::string& attributes, const std::string& title);

/// Few to many.
inline constexpr std::array<const char*, 5> kDensityColours = {"#fcbba1", "#fb6a4a", "#de2d26",
                                                               "#a50f15", "#4a0008"};

/// Squares of 7 px coloured by how many of the places fall into them, by factors, since densities
/// span decades.
/// @param places  px
/// @param corner  px; where a square begins
/// @param noun    what is counted, for the title: "stops"
std::string draw_density_squares(std::span<const Vec2> places, const Vec2& corner,
                            const std::string& noun);

}  // namespace clast::report_detail
