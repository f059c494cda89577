#pragma once
/// Where blocks can start on a terrain and which way they would go, from its heights alone.
#include <cstdint>
#include <optional>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast::study_detail {

/// Height and gradient of the ground at a place of the plan.
struct GroundSlope {
  double height = 0.0;           ///< local z, m
  Vec2 gradient = Vec2::Zero();  ///< points uphill; its length is the tangent of the slope
};

/// The uppermost ground in square cells; local frame, m.
class GroundGrid {
 public:
  /// @param cell  wanted width of a cell, m; less where the terrain is narrower than a dozen
  GroundGrid(const Terrain& terrain, double cell);

  double cell() const { return cell_; }
  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  Vec2 centre(std::uint32_t column, std::uint32_t row) const;
  /// Over three by three cells; none where one of them has no ground.
  std::optional<GroundSlope> slope(const Vec2& place) const;
  /// True when there is ground in the square of this half width around the place.
  bool covered(const Vec2& place, double half_width) const;

 private:
  std::size_t index(std::int64_t column, std::int64_t row) const;
  std::int64_t column_of(double x) const;
  std::int64_t row_of(double y) const;

  Vec2 low_ = Vec2::Zero();
  double cell_ = 0.0;
  std::uint32_t columns_ = 0, rows_ = 0;
  std::vector<double> height_;          ///< row by row from the lowest y; NaN: no ground
  std::vector<std::uint32_t> covered_;  ///< sums of covered cells below and left
};

/// The way of a point mass that starts at rest and slides down under its weight against `friction`,
/// bent by the ground: where a block would go roughly, cell by cell. Ends where the point stops or
/// the ground does.
std::vector<Vec3> fall_path(const GroundGrid& grid, const Vec2& start, double friction);

}  // namespace clast::study_detail
