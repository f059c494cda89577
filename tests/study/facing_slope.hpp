#pragma once
/// A slope with a level foot that faces any way, at map coordinates of 5e6 m.
#include <cmath>
#include <filesystem>
#include <string>

#include "core/angle.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"

namespace clast {

struct FacingSlope {
  int cells = 100;      ///< along each side
  double cell = 1.0;    ///< m
  double facing = 0.0;  ///< direction of the way down, counter-clockwise from x, rad
  double slope = 38.0 * kRadiansPerDegree;
  double foot = 0.1;  ///< where the slope ends, in half sides downhill of the middle
  Vec2 corner = Vec2(652000.0, 5203000.0);  ///< map, m

  Vec2 middle() const { return corner + 0.5 * cells * cell * Vec2::Ones(); }
  Vec2 downhill() const { return {std::cos(facing), std::sin(facing)}; }
  /// How far a place of the map is downhill of the foot, m.
  double below_foot(const Vec2& place) const {
    return downhill().dot(place - middle()) - foot * 0.5 * cells * cell;
  }
  double height(const Vec2& place) const {
    return 1800.0 + std::tan(slope) * std::max(0.0, -below_foot(place));
  }
};

/// An ESRI ASCII grid, 5 cm rough.
inline void write_slope(const std::filesystem::path& file, const FacingSlope& slope) {
  std::string text = "ncols " + std::to_string(slope.cells) + "\nnrows " +
                     std::to_string(slope.cells) + "\nxllcorner " +
                     format_decimals(slope.corner.x(), 3) + "\nyllcorner " +
                     format_decimals(slope.corner.y(), 3) + "\ncellsize " +
                     format_decimals(slope.cell, 3) + "\nNODATA_value -9999\n";
  Random random(7);
  for (int row = 0; row < slope.cells; ++row) {
    for (int column = 0; column < slope.cells; ++column) {
      const Vec2 place = slope.corner + slope.cell * Vec2(column + 0.5, slope.cells - row - 0.5);
      text += format_decimals(slope.height(place) + 0.05 * random.normal(), 3) + " ";
    }
    text += "\n";
  }
  write_text_file(file, text);
}

}  // namespace clast
