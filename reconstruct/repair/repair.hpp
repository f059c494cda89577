#pragma once
/// Repair of scanned surfaces to closed block surfaces.
#include <functional>

#include "core/fields.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast {

struct RepairOptions {
  double weld_tolerance =
      1e-5;  ///< distance within which vertices are merged, as a fraction of the diagonal
  bool keep_inner_shells = false;  ///< true: closed shells inside the block are kept as cavities;
                                   ///< false: they are removed
  /// Fills missing surface. If false, holes of more than four edges and non-manifold edges are
  /// errors, and spikes and self-intersections are kept, as for cores with exact vertices.
  bool fill_missing = true;
  double max_hole_fraction =
      0.4;  ///< maximum area of a filling as a fraction of the repaired surface
  /// Converts positions for messages and report, for example to file coordinates. If empty,
  /// positions are unchanged.
  std::function<Vec3(const Vec3&)> to_reported_position = {};

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const RepairOptions& options, Visit&& visit) {
  const auto& [weld_tolerance, keep_inner_shells, fill_missing, max_hole_fraction,
               to_reported_position] = options;
  visit("weld_tolerance", weld_tolerance);
  visit("keep_inner_shells", keep_inner_shells);
  visit("invent", fill_missing);
  visit("largest_hole", max_hole_fraction);
  visit("reported_place", ExcludedField{to_reported_position});
}

/// Maximum coordinate, m. Larger values are regarded as damaged data.
inline constexpr double kMaxCoordinate = 1e15;

struct RepairedMesh {
  TriangleMesh mesh;  ///< closed 2-manifold without self-intersections, outward; cavities inward
  RepairReport report;
};

/// Repairs a surface. The stages are: weld; remove degenerate, duplicate and protruding triangles;
/// orient; split touching sheets; close tears between existing vertices; flatten spikes; fill holes
/// [liepa2003]; replace intersecting triangles; orient outwards; remove islands, duplicate sheets
/// and copies; verify. If intersections remain, the surface is wrapped [portaneri2022] and the wrap
/// is scaled to its volume. Sound meshes are returned unchanged. See "Repair" in docs/theory.md.
/// @throws GeometryError  if a defect remains; states the defect, its position and advice
/// @cite liepa2003 portaneri2022
RepairedMesh repair_mesh(const TriangleMesh& dirty, const RepairOptions& options = {});

}  // namespace clast
