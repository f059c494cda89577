#include "reconstruct/repair/detail/other_components.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"
#include "reconstruct/repair/surface_copy.hpp"

namespace clast::reconstruct_detail {

namespace {

/// A component with less of the block's area than this is no block: dust, a scrap of ground.
constexpr double kIslandArea = 0.05;
/// Share of the diagonal within which an open component lies on the block: a part scanned twice.
constexpr double kDuplicateSheet = 0.02;

void add(RepairChange& dropped, const SurfaceComponent& component) {
  if (dropped.count++ == 0) dropped.position = component.mesh.vertices[0];
  dropped.area += component.area;
}

[[noreturn]] void refuse_components(std::size_t others, bool open, double fraction) {
  throw GeometryError(
      std::to_string(others + 1) + " separate components, the second with " +
      format_significant(100.0 * fraction, 4) + " % of the area of the first; " +
      (open ? "if they are parts of one block, align and merge them first (CloudCompare: Fine "
              "registration, then Merge); otherwise "
            : "") +
      "save each block to a separate file, or delete the other components");
}

/// Counts the shells; where they are to be kept, adds them facing the other way than the block.
void take_shells(TriangleMesh& block, const std::vector<const TriangleMesh*>& shells, bool keep,
                 RepairLog& log) {
  if (shells.empty()) return;
  const bool block_outward = signed_volume(block) > 0.0;
  log.report.inner_shells = shells.size();
  log.report.inner_shells_retained = keep;
  double area = 0.0;
  for (const TriangleMesh* shell : shells) {
    const double volume = signed_volume(*shell);
    log.report.inner_shell_volume += std::abs(volume);
    area += surface_area(*shell);
    if (!keep) continue;
    TriangleMesh cavity = *shell;
    split_non_manifold_vertices(cavity);
    if ((volume > 0.0) == block_outward) flip_orientation(cavity);
    block = merged(std::move(block), cavity);
  }
  log.add_defect(DefectKind::kInnerShell, shells.size(), area, shells[0]->vertices[0]);
}

}  // namespace

void remove_other_components(TriangleMesh& block, std::span<const SurfaceComponent> components,
                             const RepairOptions& options, RepairLog& log) {
  if (components.size() == 1) return;
  const TriangleTree tree(block);
  const double diagonal = bounds(block).diagonal(), on_block = kDuplicateSheet * diagonal;
  std::vector<const TriangleMesh*> shells;
  RepairChange islands, sheets, copies;
  std::size_t others = 0;
  bool open = false;
  for (const SurfaceComponent& component : components.subspan(1)) {
    const TriangleMesh& mesh = component.mesh;
    const bool closed = inspect_mesh(mesh).is_closed();
    const bool small = component.area < kIslandArea * components[0].area;
    if (!small) {
      if (const auto copy = match_surface_copy(mesh, tree, diagonal)) {
        add(closed ? copies : sheets, component);
        log.add_duplicate(describe_copy(*copy, component, block, tree));
        continue;
      }
    }
    const bool inside = is_inside_block(mesh, block, tree);
    const auto holds_it = [&](const TriangleMesh* shell) {
      return is_inside_block(mesh, *shell, TriangleTree(*shell));
    };
    // A component inside a bubble is smaller than the bubble, so the bubble comes first.
    if (inside && closed && std::none_of(shells.begin(), shells.end(), holds_it)) {
      shells.push_back(&mesh);
    } else if (options.fill_missing && !closed && is_on_surface(mesh, tree, on_block)) {
      add(sheets, component);
    } else if (inside || small) {
      add(islands, component);
    } else {
      ++others;
      open |= !closed;
    }
  }
  if (others > 0) refuse_components(others, open, components[1].area / components[0].area);
  log.add_defect(DefectKind::kDuplicateSheet, sheets);
  log.add_defect(DefectKind::kDuplicateShell, copies);
  log.add_defect(DefectKind::kIsland, islands);
  take_shells(block, shells, options.keep_inner_shells, log);
}

}  // namespace clast::reconstruct_detail
