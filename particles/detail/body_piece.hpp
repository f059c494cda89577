#pragma once
/// Pieces of a body between planes, with their volume and convex hull.
#include <array>
#include <optional>
#include <vector>

#include "mesh/triangle_tree.hpp"
#include "shapes/convex_cell.hpp"

namespace clast::particles_detail {

using Corners = std::array<Vec3, 3>;

/// Part of a body within a convex cell.
struct BodyPiece {
  ConvexCell cell;
  std::vector<Corners> surface;  ///< triangles of the body within the cell
  /// Signed triangles over the faces of the cell, which close `surface` as a chain; some may lie
  /// outside the body and cancel.
  std::vector<Corners> caps;
  std::vector<Vec3> inner_corners;  ///< corners of the cell inside the body
  double volume = 0.0;              ///< m^3
};

/// Makes the piece that is the whole body.
BodyPiece whole_body(const TriangleMesh& mesh);

/// Divides a piece by a plane into the pieces below and above; empty if one side is.
std::optional<std::array<BodyPiece, 2>> divided(const BodyPiece& piece, const Plane& plane,
                                                const TriangleTree& tree);

/// Returns the points of a piece: corners of its triangles and inner corners.
std::vector<Vec3> points_of(const BodyPiece& piece);

}  // namespace clast::particles_detail
