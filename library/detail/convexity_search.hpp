#pragma once
/// Search of a body with a given convexity.
#include "shapes/sphero_polyhedron.hpp"

namespace clast::library_detail {

/// Finds the body between `body` and its hull (shapes/hull_interpolation.hpp) with a given
/// convexity.
/// @throws GeometryError  if the target is below the body's convexity or above 1, or the body is
///                        not star-shaped, unless the target is its own convexity or 1
SpheroPolyhedron find_body_of_convexity(const SpheroPolyhedron& body, double initial_convexity,
                                        double target);

}  // namespace clast::library_detail
