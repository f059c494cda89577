#pragma once
/// Detection of duplicate surfaces: rocks scanned or stored twice with a small offset.
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Position and size of a copy relative to the original surface.
struct SurfaceCopy {
  double offset = 0.0;    ///< mean distance, positive outside the surface, m
  double distance = 0.0;  ///< root mean square distance, m
  double scale = 1.0;     ///< size of the copy relative to the surface
};

/// Decides if a component is a copy of the surface, by registration (point to plane [chen1992],
/// with scale). It is a copy if it was within 8 % of the diagonal from the surface, if its normals
/// are consistently equal or opposite, if the scale differs by at most 12 %, and if registration
/// improves the fit several times. Bubbles do not meet these conditions.
/// @param tree  tree of the surface, outward or inward
/// @param diagonal  diagonal of the surface, m
/// @cite chen1992
std::optional<SurfaceCopy> match_surface_copy(const TriangleMesh& component,
                                              const TriangleTree& tree, double diagonal);

/// Moves the best copy of the first component to the front. A closed copy is better than an open
/// one. Of similar copies, one with at least a quarter more triangles is better.
/// @param components  components, not empty, the largest first
void move_best_copy_first(std::vector<SurfaceComponent>& components);

/// Describes a removed copy, including the reason why the other copy was kept.
/// @param kept  retained surface, outward; `tree` is its tree
DuplicateSurface describe_copy(const SurfaceCopy& copy, const SurfaceComponent& dropped,
                               const TriangleMesh& kept, const TriangleTree& tree);

}  // namespace clast::reconstruct_detail
