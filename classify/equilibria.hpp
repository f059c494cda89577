#pragma once
/// On how many sides a block can stand: its static equilibria on a flat ground.
#include <cstddef>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Directions in which the plane that touches the block from below has the centre of mass straight
/// above the contact. @cite domokos2010
struct Equilibria {
  std::size_t stable = 0;    ///< standing on a face: the height of the centre has a minimum
  std::size_t unstable = 0;  ///< on a vertex: a maximum
  std::size_t saddle = 0;    ///< on an edge

  /// S + U - H = 2 (Poincare-Hopf); fails only where the centre is right above the border of a
  /// face or the end of an edge, to rounding.
  bool is_consistent() const { return stable + unstable == saddle + 2; }
};

/// Of the convex hull, which is all that touches a flat ground. Rounding lifts every support plane
/// by the radius and changes none. Faces within 1e-6 rad of each other are one. A finely meshed
/// round part has many equilibria close together, as scans do: count on the simplified body.
/// @param centre  centre of mass
/// @throws GeometryError  the vertices enclose no volume
Equilibria static_equilibria(const SpheroPolyhedron& body, const Vec3& centre);

}  // namespace clast
