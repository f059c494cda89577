#pragma once
/// The pieces of a surface, and which lies in or on which.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast::reconstruct_detail {

struct Piece {
  TriangleMesh mesh;
  double area = 0.0;
};

/// Pieces connected over edges, largest area first, without unused vertices.
std::vector<Piece> pieces_of(const TriangleMesh& mesh);

/// Is `point` inside the closed surface? By its winding number, so that it holds for any point and
/// either orientation.
bool encloses(const TriangleMesh& closed, const Vec3& point);

/// Is every vertex of the piece inside the block? A second block that overlaps it has some outside.
/// @param tree  of `block`, which is closed and faces either way
bool lies_inside(const TriangleMesh& piece, const TriangleMesh& block, const TriangleTree& tree);

/// Is every vertex of the piece within `distance` of the surface of the tree?
bool lies_on(const TriangleMesh& piece, const TriangleTree& tree, double distance);

}  // namespace clast::reconstruct_detail
