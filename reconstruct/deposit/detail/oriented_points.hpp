#pragma once
/// Points of a deposit with outward normals, local spacings and concavity.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Points of a scanned surface, with what their neighbourhoods say. All lists have one entry per
/// point.
struct OrientedPoints {
  Vec3 origin = Vec3::Zero();    ///< m
  std::vector<Vec3> positions;   ///< m, relative to `origin`
  std::vector<Vec3> normals;     ///< unit, towards free space
  std::vector<double> spacings;  ///< local point spacing, m
  /// Mean sine of the heights of the points around a point above its tangent plane, at about 3 and
  /// 6 spacings: positive in a crevice, negative on an edge.
  std::vector<double> concavities;
  std::size_t neighbour_count = 0;        ///< number of neighbours per point
  std::vector<std::uint32_t> neighbours;  ///< nearest points, `neighbour_count` per point
  double spacing = 0.0;                   ///< median of `spacings`, m

  std::size_t size() const { return positions.size(); }
  /// Returns the nearest neighbours of a point, the nearest first.
  std::span<const std::uint32_t> neighbours_of(std::size_t point) const {
    return {neighbours.data() + point * neighbour_count, neighbour_count};
  }
};

/// Rounds a length to a power of 2^(1/4). The sides of grids are rounded, so that they are the same
/// for a scan and its parts.
double rounded_side(double length);

/// Computes neighbours, spacings, normals and concavities.
///
/// Normals are those of the planes through the nearest points. A normal points to those directions
/// of the upper hemisphere from which its point is visible, which a depth buffer decides; points
/// that are visible from none take the sign that most of their neighbours suggest.
/// @param points  points without duplicates and outliers, at least 100
/// @param origin  origin of the positions, m; the same for all parts of a scan, near its middle
/// @param threads  number of threads, 0: one per core; does not affect the result
OrientedPoints orient_points(std::span<const Vec3> points, const Vec3& origin, unsigned threads);

}  // namespace clast::reconstruct_detail
