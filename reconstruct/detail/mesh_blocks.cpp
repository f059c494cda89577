#include "reconstruct/detail/mesh_blocks.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/cut_out.hpp"
#include "reconstruct/detail/choose_block_on_ground.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/hole_loops.hpp"
#include "reconstruct/repair/holes.hpp"
#include "reconstruct/repair/missing_faces.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"
#include "reconstruct/repair/soup.hpp"
#include "reconstruct/repair/spikes.hpp"
#include "reconstruct/repair/surface_copy.hpp"

namespace clast::reconstruct_detail {

namespace {

/// An open surface of manifold edges that faces one way, and what was repaired to have it.
struct OpenSheet {
  TriangleMesh mesh;
  RepairReport repaired;
};

/// None when cleaning alone does, or has to say what is wrong.
std::optional<OpenSheet> open_sheet(const TriangleMesh& raw, const ScanOptions& options) {
  if (!are_coordinates_valid(raw.vertices, options.unit)) return std::nullopt;
  const double tolerance = options.repair.weld_tolerance * bounds(raw).diagonal();
  TriangleMesh mesh = weld_vertices(raw, tolerance);
  RepairReport report;
  report.as_read = inspect_mesh(mesh);
  const double area = surface_area(mesh);
  const auto note = [&](DefectKind kind, std::size_t count, double dropped = 0.0,
                        std::optional<Vec3> where = {}, double size = 0.0) {
    if (count > 0) report.defects.push_back({kind, count, dropped / area, size, where});
  };
  const auto note_change = [&](DefectKind kind, const RepairChange& change) {
    note(kind, change.count, change.area, change.position);
  };
  note(DefectKind::kNearVertices, weld_vertices(raw, 0.0).vertices.size() - mesh.vertices.size(),
       0.0, {}, tolerance * options.unit);
  note(DefectKind::kDegenerate, raw.triangles.size() - mesh.triangles.size());
  const SoupRepairResult repair = repair_soup(mesh, kMaxFinAreaFraction);
  if (mesh.triangles.empty() || !repair.orientation.orientable) return std::nullopt;
  note_change(DefectKind::kFoldedPair, repair.removed_pairs);
  note_change(DefectKind::kFin, repair.removed_fins);
  note_change(DefectKind::kNonManifoldEdge, repair.split_edges);
  const std::size_t turned = repair.orientation.flipped + orient_vertex_attached_fragments(mesh);
  if (turned > 0) {
    note(DefectKind::kInconsistentOrientation, turned, 0.0,
         mesh.vertices[repair.orientation.first_flipped_vertex]);
  }
  const std::vector<FilledHole> ragged = retriangulate_missing_faces(mesh);
  if (inspect_mesh(mesh).is_closed()) return std::nullopt;
  note_change(DefectKind::kNonManifoldVertex, split_non_manifold_vertices(mesh));
  const SpikeSummary spikes = flatten_spikes(mesh);
  note(DefectKind::kSpike, spikes.count, 0.0, spikes.position, spikes.max_height * options.unit);
  report = report_with_fillings(std::move(report), ragged, surface_area(mesh), options.unit);
  return OpenSheet{std::move(mesh), std::move(report)};
}

/// Notes a copy of the surface that is dropped.
void note_copy(RepairReport& report, DuplicateSurface doubled, const SurfaceComponent& component,
               double first_area, double unit) {
  doubled.offset *= unit;
  doubled.distance *= unit;
  doubled.volume_change *= unit * unit * unit;
  doubled.retained_volume *= unit * unit * unit;
  report.volume_below = std::max(report.volume_below, -doubled.volume_change);
  report.volume_above = std::max(report.volume_above, doubled.volume_change);
  report.duplicates.push_back(doubled);
  report.defects.push_back({DefectKind::kDuplicateSheet, 1, component.area / first_area, 0.0,
                            component.mesh.vertices[0]});
}

/// Drops copies of the first component, once that is the best of them, and notes them.
/// @returns true if the first is closed and the others are copies or debris, which repair removes
bool drop_copies(std::vector<SurfaceComponent>& components, RepairReport& report, double unit) {
  move_best_copy_first(components);
  const TriangleMesh& first = components[0].mesh;
  const double diagonal = bounds(first).diagonal();
  const TriangleTree tree(first);
  bool others = false;
  std::vector<SurfaceComponent> kept;
  for (std::size_t i = 1; i < components.size(); ++i) {
    const bool scrap = components[i].area < kMaxDebrisAreaFraction * components[0].area;
    const auto copy = scrap ? std::nullopt : match_surface_copy(components[i].mesh, tree, diagonal);
    others |= !scrap && !copy;
    if (copy) {
      note_copy(report, describe_copy(*copy, components[i], first, tree), components[i],
                components[0].area, unit);
    } else {
      kept.push_back(std::move(components[i]));
    }
  }
  components.resize(1);
  for (SurfaceComponent& component : kept) components.push_back(std::move(component));
  return !others && inspect_mesh(components[0].mesh).is_closed();
}

/// True if no hole of the sheet is large enough to be an unobserved side.
bool has_only_small_holes(const TriangleMesh& sheet) {
  const double area = surface_area(sheet);
  for (const std::vector<std::uint32_t>& loop : boundary_loops(sheet)) {
    std::vector<Vec3> border;
    for (const std::uint32_t v : loop) border.push_back(sheet.vertices[v]);
    if (is_unobserved_side(border, area)) return false;
  }
  return true;
}

/// Returns a note if the second component is too large for debris. The first is the block.
std::string left_out(const std::vector<SurfaceComponent>& components) {
  if (components.size() < 2 || components[1].area <= kMaxDebrisAreaFraction * components[0].area)
    return "";
  return "another component of the scan close to this block, with " +
         format_significant(100.0 * components[1].area / components[0].area, 3) +
         " % of its area, near " + format_point(components[1].mesh.vertices[0]) +
         ", was left out; to make both, save each to a separate file";
}

FieldBlock block_on_ground(const OpenSheet& sheet, const TriangleMesh& raw,
                           const std::vector<Vec3>& points, const Ground& ground,
                           const std::string& name, const FieldScanOptions& options) {
  const BlocksOnGround found = find_blocks_on_ground(points, ground);
  if (found.blocks.empty()) {
    throw_only_ground_error(
        name, static_cast<double>(found.ground.size()) / static_cast<double>(points.size()));
  }
  const ChosenBlock chosen = choose_block_on_ground(points, ground, found);
  const PointTree tree(points);
  std::vector<SurfaceComponent> components =
      extract_nearest_components(sheet.mesh, tree, chosen.point_indices);
  if (components.empty()) throw_only_ground_error(name, 1.0);
  const std::string others = left_out(components);
  TriangleMesh rock = std::move(components.front().mesh);
  split_non_manifold_vertices(rock);
  FieldBlock block = close_block({.surface = std::move(rock),
                                  .ground = chosen.ground,
                                  .centre = chosen.centre,
                                  .raw = &raw,
                                  .repaired = sheet.repaired,
                                  .notes = chosen.notes},
                                 name, options);
  if (!others.empty()) block.scan.notes.push_back(others);
  return block;
}

}  // namespace

bool is_closed_body(const TriangleMesh& raw, const ScanOptions& options) {
  const std::optional<OpenSheet> sheet = open_sheet(raw, options);
  return !sheet || has_only_small_holes(sheet->mesh);
}

std::vector<FieldBlock> extract_mesh_blocks(const TriangleMesh& raw, const std::string& name,
                                            const FieldScanOptions& options) {
  std::optional<OpenSheet> sheet = open_sheet(raw, options.scan);
  if (!sheet) return {clean_block(raw, name, options)};
  std::vector<SurfaceComponent> components = connected_components(sheet->mesh);
  if (drop_copies(components, sheet->repaired, options.scan.unit)) {
    return {clean_block(raw, name, options)};
  }
  if (!sheet->repaired.duplicates.empty()) {
    sheet->mesh = {};
    for (const SurfaceComponent& component : components)
      sheet->mesh = merged(std::move(sheet->mesh), component.mesh);
  }
  if (options.find_ground && !has_only_small_holes(sheet->mesh)) {
    const std::vector<Vec3> points = sample_surface_points(sheet->mesh);
    if (const std::optional<Ground> ground = find_ground(points)) {
      return {block_on_ground(*sheet, raw, points, *ground, name, options)};
    }
  }
  double scraps = 0.0;
  for (std::size_t i = 1; i < components.size(); ++i) {
    if (components[i].area > kMaxDebrisAreaFraction * components[0].area) {
      return {clean_block(raw, name, options)};  // says what is wrong
    }
    scraps += components[i].area / surface_area(sheet->mesh);
  }
  if (components.size() > 1) {
    sheet->repaired.defects.push_back(
        {DefectKind::kIsland, components.size() - 1, scraps, 0.0, components[1].mesh.vertices[0]});
  }
  return {close_block({.surface = std::move(components[0].mesh),
                       .raw = &raw,
                       .repaired = std::move(sheet->repaired)},
                      name, options)};
}

}  // namespace clast::reconstruct_detail
