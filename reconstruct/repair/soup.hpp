#pragma once
/// Conversion of triangle soups to manifold, consistently oriented components.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Number, area and position of the changes of a repair step.
struct RepairChange {
  std::size_t count = 0;
  double area = 0.0;             ///< removed area
  Vec3 position = Vec3::Zero();  ///< position of the first change; undefined if `count` is 0
};

/// Removes the marked triangles and unused vertices. Returns the number of removed triangles.
/// @param drop  one flag per triangle
RepairChange remove_triangles(TriangleMesh& mesh, const std::vector<bool>& drop);

/// Removes one or both triangles of each pair of coincident, opposite triangles. One is removed if
/// the surface continues on both sides, as in surfaces that are stored twice. Both are removed if
/// they are a sliver closed by welding. Returns the number of removed triangles.
RepairChange remove_opposite_pairs(TriangleMesh& mesh);

/// Maximum area of a fin as a fraction of the surface area.
inline constexpr double kMaxFinAreaFraction = 0.05;

/// Removes fins and overlying sheets. These are small parts at non-manifold edges that continue the
/// surface less smoothly than the others. Returns the number of removed triangles.
/// @param max_fin_fraction  maximum area of such a part as a fraction of the surface area
RepairChange remove_fins(TriangleMesh& mesh, double max_fin_fraction);

/// Removes fins at borders: triangles that are attached by a single edge and have a free vertex.
/// Only used if the scan has other fins. Returns the number of removed triangles.
RepairChange remove_border_fins(TriangleMesh& mesh);

struct OrientationResult {
  std::size_t flipped = 0;  ///< number of flipped triangles
  bool orientable = true;
  std::uint32_t conflict_vertex = 0;       ///< vertex where orientations conflict
  std::uint32_t first_flipped_vertex = 0;  ///< vertex of the first flipped triangle
};

/// Orients triangles consistently across manifold edges. Each component keeps the orientation of
/// the majority of its triangles.
OrientationResult orient_consistently(TriangleMesh& mesh);

/// Repairs made by each step of `repair_soup`.
struct SoupRepairResult {
  RepairChange removed_pairs, removed_fins, split_edges;
  OrientationResult
      orientation;  ///< orientation before and after splitting edges; counts are added
};

/// Makes the edges of a triangle soup manifold, by the functions above and
/// `split_non_manifold_edges`. If orientations conflict at few triangles, these are removed. In the
/// result, all edges are manifold and consistently oriented. If this is impossible, `orientation`
/// reports the conflict, and the mesh is not completely processed.
/// @param max_fin_fraction  maximum area of a fin as a fraction of the surface area
SoupRepairResult repair_soup(TriangleMesh& mesh, double max_fin_fraction);

}  // namespace clast::reconstruct_detail
