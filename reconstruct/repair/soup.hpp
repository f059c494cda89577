#pragma once
/// Conversion of triangle soups to manifold, consistently oriented components.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct RepairChange {
  std::size_t count = 0;
  double area = 0.0;             ///< removed area
  Vec3 position = Vec3::Zero();  ///< of the first; undefined if `count` is 0
};

/// Removes the marked triangles and unused vertices. Counts triangles.
/// @pre one flag per triangle
RepairChange remove_triangles(TriangleMesh& mesh, const std::vector<bool>& drop);

/// Removes pairs of coincident, opposite triangles: one of them if the surface continues on both
/// sides (stored twice, or two-sided throughout), both if they are a welded sliver. Counts
/// triangles.
RepairChange remove_opposite_pairs(TriangleMesh& mesh);

/// Maximum area fraction of a fin.
inline constexpr double kFinArea = 0.05;

/// Removes fins and overlying sheets: small parts attached at non-manifold edges that continue less
/// smoothly than the rest. Counts triangles.
/// @param largest_share  maximum area fraction of such a part
RepairChange remove_fins(TriangleMesh& mesh, double largest_share);

/// Removes triangles attached by a single edge with a free tip: fins at borders, for scans with
/// fins elsewhere. Counts triangles.
RepairChange remove_border_fins(TriangleMesh& mesh);

struct OrientationResult {
  std::size_t flipped = 0;  ///< number of flipped triangles
  bool orientable = true;
  std::uint32_t conflict = 0;  ///< vertex where orientations conflict
  std::uint32_t first = 0;     ///< vertex of the first flipped triangle
};

/// Orients triangles consistently over manifold edges; each component keeps the majority
/// orientation.
OrientationResult orient_consistently(TriangleMesh& mesh);

/// Result of all steps above and `split_non_manifold_edges`.
struct SoupRepairResult {
  RepairChange folded, fins, touching;
  OrientationResult orientation;  ///< counts both passes
};

/// Runs all steps. If orientations conflict and few triangles are affected, these are removed: two
/// sheets that touched along an edge each lost one there. Afterwards all edges are manifold and
/// consistently oriented; otherwise `orientation` reports it and the mesh is incomplete.
/// @param max_fin_fraction  maximum area fraction of a fin
SoupRepairResult repair_soup(TriangleMesh& mesh, double max_fin_fraction);

}  // namespace clast::reconstruct_detail
