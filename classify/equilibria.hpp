#pragma once
/// Static equilibria of a block on flat ground.
#include <cstddef>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Numbers of static equilibria: orientations in which the centre of mass is vertically above the
/// contact with a horizontal plane. @cite domokos2010
struct StaticEquilibriumCounts {
  std::size_t stable = 0;    ///< resting on a face: minimum of the height of the centre of mass
  std::size_t unstable = 0;  ///< resting on a vertex: maximum of this height
  std::size_t saddle = 0;    ///< resting on an edge: saddle point of this height

  /// True if stable + unstable - saddle = 2 (Poincare-Hopf). Rounding errors can violate this if
  /// the centre of mass projects onto the border of a face or the end of an edge.
  bool is_consistent() const { return stable + unstable == saddle + 2; }
};

/// Counts the static equilibria of the body's convex hull; the rounding radius does not change
/// them. Faces within 1e-6 rad of each other are treated as one. Finely meshed round parts have
/// many equilibria, so use simplified bodies.
/// @param centre  centre of mass
/// @throws GeometryError  if the vertices enclose no volume
StaticEquilibriumCounts count_static_equilibria(const SpheroPolyhedron& body, const Vec3& centre);

}  // namespace clast
