#pragma once
/// From triangles that meet anyhow to components that are manifold and face one way.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// What one step of a repair dropped or changed.
struct RepairChange {
  std::size_t count = 0;
  double area = 0.0;             ///< of what was dropped
  Vec3 position = Vec3::Zero();  ///< of the first; meaningless when `count` is 0
};

/// Drops the marked triangles, and the vertices that only they use. Counts triangles.
/// @pre one flag for each triangle
RepairChange remove_triangles(TriangleMesh& mesh, const std::vector<bool>& drop);

/// Of two triangles with the same corners and opposite turn, one is kept where the surface goes on
/// at both sides (stored twice, or two-sided throughout), none where it doesn't (a sliver welded
/// flat). Counts those dropped.
RepairChange remove_opposite_pairs(TriangleMesh& mesh);

/// A part of the surface that stands on the rest and has less of its area than this is a fin.
inline constexpr double kFinArea = 0.05;

/// Drops small parts of the surface that meet the rest on edges of more than two triangles and go
/// on less smoothly there than the rest does without them: fins, and sheets that lie on the
/// surface. Counts triangles.
/// @param largest_share  of the area that such a part may have
RepairChange remove_fins(TriangleMesh& mesh, double largest_share);

/// Drops triangles that meet the rest on one edge alone and have a tip of their own. In a scan that
/// has fins elsewhere they are fins that stand on a border. Counts triangles.
RepairChange remove_border_fins(TriangleMesh& mesh);

struct OrientationResult {
  std::size_t flipped = 0;  ///< triangles that were flipped
  bool orientable = true;
  std::uint32_t conflict = 0;  ///< a vertex where the sides can't agree
  std::uint32_t first = 0;     ///< a vertex of the first triangle that was flipped
};

/// Makes neighbours over edges with two triangles agree; each component keeps the turn that most of
/// its triangles have.
OrientationResult orient_consistently(TriangleMesh& mesh);

/// All of the above, and `split_non_manifold_edges`, in order.
struct SoupRepairResult {
  RepairChange folded, fins, touching;
  OrientationResult orientation;  ///< counts both rounds
};

/// Where sides can't agree and few triangles face another way than a neighbour, those are
/// removed: of two sheets that touched along an edge, each lost one there. After this every edge
/// has one triangle or two, and neighbours face the same way; where they can't, `orientation` says
/// so and the mesh is left half done.
/// @param max_fin_fraction  share of the area that a fin may have
SoupRepairResult repair_soup(TriangleMesh& mesh, double max_fin_fraction);

}  // namespace clast::reconstruct_detail
