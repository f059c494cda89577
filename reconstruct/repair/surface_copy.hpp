#pragma once
/// Whether a component is a second copy of the block's surface: the same rock, scanned or stored
/// twice and placed a little apart.
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// The position of a copy relative to the surface that it copies.
struct SurfaceCopy {
  double offset = 0.0;    ///< mean distance, positive outside the surface, m
  double distance = 0.0;  ///< root mean square distance, m
  double scale = 1.0;     ///< of the copy relative to the surface
};

/// Moves, turns and scales the component until it lies on the surface as well as it can (point to
/// plane [chen1992], with a scale). It is a copy where it was no farther from it than 8 % of the
/// diagonal, faced as the surface does there (or the other way) throughout, needs to be scaled by
/// 12 % at most, and fits several times better after than before. A bubble fits nowhere, or faces
/// both ways.
/// @param tree      of the surface, which faces outwards or inwards
/// @param diagonal  of the surface, m
/// @cite chen1992
std::optional<SurfaceCopy> match_surface_copy(const TriangleMesh& component, const TriangleTree& tree,
                                           double diagonal);

/// Where another component is a copy of the first and better than it, that one becomes the first: a
/// closed one is better than an open one, and of two alike the one with a quarter more triangles.
/// @param components  at least one, the largest first
void move_best_copy_first(std::vector<Component>& components);

/// What is to be reported of a copy that is dropped: why the other was kept, and what it would
/// change.
/// @param kept  a surface that faces outwards, of which the tree is
DuplicateSurface describe_copy(const SurfaceCopy& copy, const Component& dropped,
                             const TriangleMesh& kept, const TriangleTree& tree);

}  // namespace clast::reconstruct_detail
