#pragma once
/// Detection of duplicate surfaces: the same rock, scanned or stored twice with a small offset.
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Position of a copy relative to the original surface.
struct SurfaceCopy {
  double offset = 0.0;    ///< mean distance, positive outside the surface, m
  double distance = 0.0;  ///< root mean square distance, m
  double scale = 1.0;     ///< of the copy relative to the surface
};

/// Registers a component to the surface (point to plane [chen1992], with scale). It is a copy if it
/// was within 8 % of the diagonal, has consistent (or consistently opposite) normals, needs at most
/// 12 % scaling, and fits several times better afterwards. Bubbles do not fit, or face both ways.
/// @param tree  of the surface, outward or inward
/// @param diagonal  of the surface, m
/// @cite chen1992
std::optional<SurfaceCopy> match_surface_copy(const TriangleMesh& component,
                                              const TriangleTree& tree, double diagonal);

/// Moves the best copy of the first component to the front: closed is better than open, and of
/// similar ones a quarter more triangles is better.
/// @param components  not empty, the largest first
void move_best_copy_first(std::vector<Component>& components);

/// Describes a removed copy: why the other was kept, and the volume change.
/// @param kept  outward surface of the tree
DuplicateSurface describe_copy(const SurfaceCopy& copy, const Component& dropped,
                               const TriangleMesh& kept, const TriangleTree& tree);

}  // namespace clast::reconstruct_detail
