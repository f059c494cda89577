#pragma once
/// Convex polyhedra clipped by planes.
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/plane.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Bounded convex polyhedron. Faces share vertices, so that it stays closed when clipped.
class ConvexCell {
 public:
  explicit ConvexCell(const Bounds& box);

  /// Returns the part below a plane; empty if there is none. Vertices within `tolerance` (m) of the
  /// plane count as on it.
  std::optional<ConvexCell> clipped_below(const Plane& plane, double tolerance) const;

  const std::vector<Vec3>& vertices() const { return vertices_; }
  /// Returns the planes of the faces, with outward normals.
  std::vector<Plane> planes() const;
  Bounds box() const;
  double volume() const;  ///< m^3
  Vec3 centre() const;    ///< mean of the vertices, which is inside
  TriangleMesh mesh() const;
  /// Returns the cell as a mesh, with vertices merged within 1e-4 of its size; empty if it is flat.
  std::optional<TriangleMesh> welded_mesh() const;

 private:
  ConvexCell() = default;
  std::vector<Vec3> vertices_;
  std::vector<std::vector<std::uint32_t>> faces_;  ///< counter-clockwise seen from outside
};

/// Returns the largest rounded body inside a convex polyhedron. Its core is the set of points at
/// least `radius` below all faces.
/// @param polyhedron  closed, outward, convex
/// @return body; empty if no point is that deep
std::optional<SpheroPolyhedron> inscribed_rounded_body(const TriangleMesh& polyhedron,
                                                       double radius);

}  // namespace clast
