#pragma once
/// Connected components of surfaces, and their containment.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast::reconstruct_detail {

struct Component {
  TriangleMesh mesh;
  double area = 0.0;
};

/// Returns the components connected over edges, largest area first, without unused vertices.
std::vector<Component> connected_components(const TriangleMesh& mesh);

/// True if the closed surface encloses `point`, by its winding number, for either orientation; the
/// point must not lie on the surface.
bool encloses(const TriangleMesh& closed, const Vec3& point);

/// True if all vertices of the component are inside the block or touch it from inside. Overlapping
/// blocks have vertices outside; touching ones have their centre outside.
/// @param tree  of `block`, which is closed, with either orientation
bool is_inside_block(const TriangleMesh& component, const TriangleMesh& block,
                     const TriangleTree& tree);

/// True if all vertices of the component are within `distance` of the surface.
bool is_on_surface(const TriangleMesh& component, const TriangleTree& tree, double distance);

}  // namespace clast::reconstruct_detail
