#pragma once
/// Search of a body with a given convexity.
#include "shapes/sphero_polyhedron.hpp"

namespace clast::library_detail {

/// Finds the body with a given convexity among those between `body` and its hull
/// (shapes/hull_interpolation.hpp).
/// @throws GeometryError  if the target is below the convexity of the body or above 1. Also if the
///                        body is not star-shaped and the target is neither its convexity nor 1
SpheroPolyhedron find_body_with_convexity(const SpheroPolyhedron& body, double initial_convexity,
                                          double target);

}  // namespace clast::library_detail
