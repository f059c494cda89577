#pragma once
/// Polygons in the plan, as users draw them: corners in either order, the first repeated at the end
/// or not.
#include <cstddef>
#include <optional>
#include <span>

#include "core/types.hpp"

namespace clast {

/// The first corner at which the polygon turns against its own sense, so that it is not convex;
/// none of a convex one, which may have corners on a side and repeat its first.
std::optional<std::size_t> find_reflex_vertex(std::span<const Vec2> polygon);

/// @throws InputError  fewer than three corners, or all on one line
void check_has_area(std::span<const Vec2> polygon);

}  // namespace clast
