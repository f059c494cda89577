#pragma once
/// Convex polyhedra clipped by planes.
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/plane.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Bounded convex polyhedron with shared vertices, so that it stays closed when clipped.
class ConvexCell {
 public:
  explicit ConvexCell(const Bounds& box);

  /// Returns the part below a plane; empty if there is none. Vertices within `tolerance`, m, count
  /// as on the plane.
  std::optional<ConvexCell> clipped_below(const Plane& plane, double tolerance) const;

  const std::vector<Vec3>& vertices() const { return vertices_; }
  /// Returns the planes of its faces, normals outwards.
  std::vector<Plane> planes() const;
  Bounds box() const;
  double volume() const;  ///< m^3
  Vec3 centre() const;    ///< mean of the vertices, inside
  TriangleMesh mesh() const;
  /// Returns its hull without vertices that coincide to 1e-4 of its size; empty if it is flat.
  std::optional<TriangleMesh> cleaned_mesh() const;

 private:
  ConvexCell() = default;
  std::vector<Vec3> vertices_;
  std::vector<std::vector<std::uint32_t>> faces_;  ///< counter-clockwise seen from outside
};

/// Returns the largest rounded body inside a convex polyhedron, with rounded edges and vertices:
/// its core is the set at depth `radius` or more below all faces.
/// @param polyhedron  closed, outward, convex
/// @return empty if no point is that deep
std::optional<SpheroPolyhedron> inscribed_rounded_body(const TriangleMesh& polyhedron,
                                                       double radius);

}  // namespace clast
