#pragma once
/// Checks of polygons in plan, given by the user in either orientation. The first vertex may be
/// repeated at the end.
#include <cstddef>
#include <optional>
#include <span>

#include "core/types.hpp"

namespace clast {

/// Finds the first reflex vertex; empty if the polygon is convex, also with collinear vertices.
std::optional<std::size_t> find_reflex_vertex(std::span<const Vec2> polygon);

/// Checks that a polygon has an area.
/// @throws InputError  if there are fewer than three vertices, or all are collinear
void check_has_area(std::span<const Vec2> polygon);

}  // namespace clast
