#pragma once
/// Checks of user-drawn plan polygons. Either orientation; the first vertex may also be the last.
#include <cstddef>
#include <optional>
#include <span>

#include "core/types.hpp"

namespace clast {

/// Finds the first reflex vertex; empty if the polygon is convex, also with collinear vertices.
std::optional<std::size_t> find_reflex_vertex(std::span<const Vec2> polygon);

/// Checks that the polygon has an area.
/// @throws InputError  if there are fewer than three vertices, or all are collinear
void check_has_area(std::span<const Vec2> polygon);

}  // namespace clast
