#pragma once
/// The sound rocks of the reliability trial, and what is true of them.
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reliability {

/// Exact volume, m^3, and sides of the smallest box, m.
struct Truth {
  double volume = 0.0;
  Axes axes;
};

/// @param closed  its signed volume counts, also where it passes through itself
Truth truth_of(const TriangleMesh& closed);

/// A closed mesh, its smallest box 1 m long and about the origin.
struct Body {
  std::string name;
  TriangleMesh mesh;  ///< at most about 2,000 vertices
  TriangleMesh fine;  ///< the same surface of at least 1,500 triangles
  Truth truth;
};

/// Every closed mesh of the test data, simplified where it is finer than that, and rocks of the
/// project's own: compact, platy, needles, cubes, concave ones.
/// @throws InputError  the test data is missing, or a mesh does not have its reference volume
std::vector<Body> make_bodies();

}  // namespace clast::reliability
