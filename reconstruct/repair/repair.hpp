#pragma once
/// From any surface that a scanner wrote to one that bounds a block.
#include <functional>

#include "core/fields.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast {

/// What a repair may do.
struct RepairOptions {
  double weld_tolerance = 1e-5;  ///< share of the diagonal within which vertices are one
  bool keep_inner_shells =
      false;  ///< closed shells inside stay as cavities; false: rock fills them
  /// May surface be invented? False for a core, of which every vertex is meant: holes of more than
  /// four edges and edges of more than two triangles are refused then, spikes and crossings stay.
  bool fill_missing = true;
  double largest_hole = 0.4;  ///< share of the repaired surface that one filling may be
  /// How places are given in messages and report, for example in the coordinates of the scan's
  /// file; empty: in those of the mesh.
  std::function<Vec3(const Vec3&)> reported_place = {};

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const RepairOptions& options, Visit&& visit) {
  const auto& [weld_tolerance, keep_inner_shells, fill_missing, largest_hole, reported_place] = options;
  visit("weld_tolerance", weld_tolerance);
  visit("keep_inner_shells", keep_inner_shells);
  visit("invent", fill_missing);
  visit("largest_hole", largest_hole);
  visit("reported_place", ExcludedField{reported_place});
}

/// Coordinates beyond this (m) are no place on Earth or any rock: the file is damaged. Squares and
/// cubes of lengths stay finite below it.
inline constexpr double kMaxCoordinate = 1e15;

struct RepairedMesh {
  TriangleMesh mesh;  ///< closed, 2-manifold, outward, crosses itself nowhere; cavities inward
  RepairReport report;
};

/// Welds, drops what has no area, is doubled or stands off, orients, cuts touching sheets apart,
/// closes torn places between the vertices that are there, puts spikes back, fills holes (Liepa
/// 2003), replaces crossing triangles, turns outward, drops islands, double sheets and second
/// copies of the surface, and verifies. Where crossings can't be replaced, the surface with its
/// holes filled is wrapped (Portaneri et al. 2022) and scaled back to its volume. A sound mesh
/// comes back as it is. Order and limits: docs/theory.md, "Repair".
/// @throws GeometryError  which defect remains, where, and what a person can do
/// @cite liepa2003 portaneri2022
RepairedMesh repair_mesh(const TriangleMesh& dirty, const RepairOptions& options = {});

}  // namespace clast
