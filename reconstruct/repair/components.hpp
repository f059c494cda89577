#pragma once
/// The components of a surface, and which lies in or on which.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast::reconstruct_detail {

struct Component {
  TriangleMesh mesh;
  double area = 0.0;
};

/// Components connected over edges, largest area first, without unused vertices.
std::vector<Component> connected_components(const TriangleMesh& mesh);

/// True if the closed surface encloses `point`, by its winding number: for either orientation, and
/// any point that does not lie on the surface.
bool encloses(const TriangleMesh& closed, const Vec3& point);

/// True if every vertex of the component lies inside the block or touches it from inside. A second
/// block that overlaps the first has some outside; one that touches it has its middle outside.
/// @param tree  of `block`, which is closed and faces either way
bool is_inside_block(const TriangleMesh& component, const TriangleMesh& block,
                 const TriangleTree& tree);

/// Is every vertex of the component within `distance` of the surface of the tree?
bool is_on_surface(const TriangleMesh& component, const TriangleTree& tree, double distance);

}  // namespace clast::reconstruct_detail
