#pragma once
/// A body whose hollows are filled to a convexity.
#include "shapes/sphero_polyhedron.hpp"

namespace clast::library_detail {

/// The body between `body` and its hull (shapes/hull_interpolation.hpp) that has the convexity
/// `target`.
/// @param own  convexity of `body`
/// @throws GeometryError  a target below the body's own or above 1; a body that is not star-shaped,
///                        unless the target is its own or 1
SpheroPolyhedron find_body_of_convexity(const SpheroPolyhedron& body, double initial_convexity,
                                        double target);

}  // namespace clast::library_detail
