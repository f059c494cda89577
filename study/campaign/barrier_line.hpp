#pragma once
/// Lines on the map: where crossings can be counted, what a ring encloses, and where a line meets
/// itself.
#include <cstddef>
#include <optional>
#include <span>

#include "core/types.hpp"

namespace clast {

/// A line that ends at its first point encloses an area of the map.
bool is_ring(std::span<const Vec2> line);

/// Whether a ring runs around its inside with it on the left (counter-clockwise).
bool inside_is_left(std::span<const Vec2> ring);

/// Two segments of a line that meet beside the points that they share: it crosses, touches or
/// retraces itself there.
struct SelfTouch {
  std::size_t first = 0, second = 0;  ///< segments, from 0
  Vec2 place = Vec2::Zero();
};
/// The first of them.
/// @param line  map, m; two points at least, neighbours differ; a ring ends at its first point
std::optional<SelfTouch> find_self_touch(std::span<const Vec2> line);

/// Refuses a line at which a block could not be counted, since two of its segments meet beside the
/// points that they share: it crosses, touches or retraces itself.
/// @param line  map, m; two points at least, neighbours differ
/// @throws InputError  both segments, numbered from 1, and the place
void check_barrier_line(std::span<const Vec2> line);

}  // namespace clast
