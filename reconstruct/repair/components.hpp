#pragma once
/// Connected components of surfaces, and their containment.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast::reconstruct_detail {

struct SurfaceComponent {
  TriangleMesh mesh;
  double area = 0.0;
};

/// Returns the edge-connected components without unused vertices, that of largest area first.
std::vector<SurfaceComponent> connected_components(const TriangleMesh& mesh);

/// True if the closed surface encloses `point`, as given by the winding number. The surface may
/// have either orientation. The point must not lie on it.
bool encloses(const TriangleMesh& closed, const Vec3& point);

/// True if the component is inside the block; it may touch the surface of the block from inside. A
/// component that overlaps the block or touches it from outside is not inside.
/// @param block  closed, with either orientation
/// @param tree  search tree of the triangles of `block`
bool is_inside_block(const TriangleMesh& component, const TriangleMesh& block,
                     const TriangleTree& tree);

/// True if all vertices of the component are within `distance` of the surface.
bool is_on_surface(const TriangleMesh& component, const TriangleTree& tree, double distance);

}  // namespace clast::reconstruct_detail
