#pragma once
/// Observed surface of a block in one scan, as registration needs it.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/plane.hpp"

namespace clast::reconstruct_detail {

/// Points of an observed surface at an even spacing, with outward normals. Lists have one entry per
/// point. Lengths are in metres.
struct OrientedSurface {
  std::vector<Vec3> points;               ///< smoothed: on the planes of their neighbours
  std::vector<Vec3> normals;              ///< unit, outward
  std::vector<bool> is_border;            ///< true at the border of the observed part
  std::size_t neighbour_count = 0;        ///< number of neighbours per point
  std::vector<std::uint32_t> neighbours;  ///< nearest points, `neighbour_count` per point
  double spacing = 0.0;                   ///< of the points
  double noise = 0.0;                ///< standard deviation of the scanned points about the surface
  double point_noise = 0.0;          ///< the same for the mean of the scanned points per point
  std::optional<Plane> ground = {};  ///< ground on which the block lay; its normal points up

  std::size_t size() const { return points.size(); }
  std::span<const std::uint32_t> neighbours_of(std::size_t point) const {
    return {neighbours.data() + point * neighbour_count, neighbour_count};
  }
};

/// Number of cells, each with one point, around a plane to which a point is moved. Points within
/// them share scanned points, so that their errors are not independent.
inline constexpr double kCellsPerPlane = 16.0;

/// Returns a surface with all lengths multiplied by a factor.
OrientedSurface scaled(OrientedSurface surface, double factor);

/// Cell (m) of which registration uses one point each: their spacing, or more
/// for dense scans. Scans of one block need a common cell, the largest of theirs, so that their
/// edges are rounded alike.
double registration_cell(std::span<const Vec3> points);

/// Chooses one point of each cell, moves it to the plane of the points around it and estimates its
/// normal. The neighbourhood is as wide as a few cells however dense the points are. Normals have
/// the signs that propagate from neighbour to neighbour, outward on the whole.
/// @param points  points of one block without outliers, m
/// @param cell  side of the cells, m
/// @cite hoppe1992
OrientedSurface orient_surface(std::span<const Vec3> points, double cell,
                               const std::optional<Plane>& ground);

}  // namespace clast::reconstruct_detail
