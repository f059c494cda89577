#pragma once
/// A convex polyhedron that planes are cut from.
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/plane.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Bounded and solid. Every vertex is stored once, so that what is cut stays closed.
class ConvexCell {
 public:
  /// The box.
  explicit ConvexCell(const Bounds& box);

  /// The part below a plane; none where there is nothing. Vertices within `tolerance`, m, of the
  /// plane count as on it.
  std::optional<ConvexCell> clipped_below(const Plane& plane, double tolerance) const;

  const std::vector<Vec3>& vertices() const { return vertices_; }
  /// The planes of its faces, normals outwards.
  std::vector<Plane> planes() const;
  Bounds box() const;
  double volume() const;  ///< m^3
  Vec3 centre() const;    ///< mean of the vertices, inside
  TriangleMesh mesh() const;
  /// The same without vertices that nearly coincide, to 1e-4 of its size; none: it is flat.
  std::optional<TriangleMesh> cleaned_mesh() const;

 private:
  ConvexCell() = default;
  std::vector<Vec3> vertices_;
  std::vector<std::vector<std::uint32_t>> faces_;  ///< counter-clockwise seen from outside
};

/// The largest rounded body inside a convex polyhedron: its core is what lies `radius` or more
/// below all faces. Faces are those of the polyhedron, edges and corners are round.
/// @param polyhedron  closed, outward, convex
/// @return none: nothing lies so deep
std::optional<SpheroPolyhedron> inscribed_rounded_body(const TriangleMesh& polyhedron,
                                                       double radius);

}  // namespace clast
