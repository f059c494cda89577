#pragma once
/// Geometry of barrier lines in plan: rings and self-intersections.
#include <cstddef>
#include <optional>
#include <span>

#include "core/types.hpp"

namespace clast {

/// True if a barrier line is a ring: it ends at its first point.
bool is_ring(std::span<const Vec2> line);

/// True if a ring is counter-clockwise, so that its inside is on the left.
bool is_counter_clockwise(std::span<const Vec2> ring);

/// Self-intersection of a line: two segments that cross, touch or overlap elsewhere than at a
/// shared vertex.
struct LineSelfIntersection {
  std::size_t first = 0, second = 0;  ///< segment indices, from 0
  Vec2 position = Vec2::Zero();
};
/// Finds the first self-intersection of a line.
/// @param line  plan coordinates, m; at least two points; consecutive points differ; a ring ends at
///              its first point
std::optional<LineSelfIntersection> find_line_self_intersection(std::span<const Vec2> line);

/// Checks that a barrier line has no self-intersection.
/// @param line  plan coordinates, m; at least two points, consecutive points differ
/// @throws InputError  if the line has a self-intersection; names both segments, counted from 1,
///                     and the position
void check_barrier_line(std::span<const Vec2> line);

}  // namespace clast
