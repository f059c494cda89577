#pragma once
/// Repair of scanned surfaces to closed block surfaces.
#include <functional>

#include "core/fields.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast {

struct RepairOptions {
  double weld_tolerance = 1e-5;  ///< fraction of the diagonal within which vertices are merged
  bool keep_inner_shells =
      false;  ///< closed shells inside stay as cavities; false: rock fills them
  /// True: missing surface is filled. False for a core, whose vertices are exact: holes of more
  /// than four edges and non-manifold edges are errors, spikes and self-intersections are kept.
  bool fill_missing = true;
  double largest_hole =
      0.4;  ///< largest fraction of the repaired surface that one filling may have
  /// Converts positions for messages and report, for example to file coordinates; empty: unchanged.
  std::function<Vec3(const Vec3&)> reported_place = {};

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const RepairOptions& options, Visit&& visit) {
  const auto& [weld_tolerance, keep_inner_shells, fill_missing, largest_hole, reported_place] =
      options;
  visit("weld_tolerance", weld_tolerance);
  visit("keep_inner_shells", keep_inner_shells);
  visit("invent", fill_missing);
  visit("largest_hole", largest_hole);
  visit("reported_place", ExcludedField{reported_place});
}

/// Maximum coordinate, m. Larger values are damaged data; squares and cubes of lengths stay finite
/// below it.
inline constexpr double kMaxCoordinate = 1e15;

struct RepairedMesh {
  TriangleMesh mesh;  ///< closed, 2-manifold, outward, without self-intersections; cavities inward
  RepairReport report;
};

/// Repairs a surface in stages: weld; remove degenerate, duplicate and protruding triangles;
/// orient; split touching sheets; close tears between existing vertices; flatten spikes; fill holes
/// (Liepa 2003); replace intersecting triangles; orient outwards; remove islands, duplicate sheets
/// and copies; verify. If intersections remain, the filled surface is wrapped (Portaneri et al.
/// 2022) and scaled to its volume. Sound meshes are returned unchanged. Order and limits:
/// docs/theory.md, "Repair".
/// @throws GeometryError  naming the remaining defect, its position and advice
/// @cite liepa2003 portaneri2022
RepairedMesh repair_mesh(const TriangleMesh& dirty, const RepairOptions& options = {});

}  // namespace clast
