#include "reconstruct/repair/repair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/crossing_repair.hpp"
#include "reconstruct/repair/detail/other_components.hpp"
#include "reconstruct/repair/detail/repair_log.hpp"
#include "reconstruct/repair/detail/unsound_surface.hpp"
#include "reconstruct/repair/hole_loops.hpp"
#include "reconstruct/repair/holes.hpp"
#include "reconstruct/repair/missing_faces.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"
#include "reconstruct/repair/soup.hpp"
#include "reconstruct/repair/spikes.hpp"
#include "reconstruct/repair/surface_copy.hpp"

namespace clast {

namespace {

using reconstruct_detail::RepairChange;
using reconstruct_detail::RepairLog;
using reconstruct_detail::SpikeSummary;
using reconstruct_detail::SurfaceComponent;

/// Welds tried on an open surface, as multiples of the tolerance, while each halves its borders.
constexpr double kWelds[] = {1.0, 10.0, 100.0};
/// ... and joins no more vertices than so many for each open edge.
constexpr std::size_t kJoinedPerOpenEdge = 8;
/// Above this many diagonals from the origin, the work is done about a nearer one.
constexpr double kFarAway = 10.0;

/// Near the middle of a mesh that lies far from the origin, and such that taking it from the
/// coordinates and adding it again loses no bit of them; zero for other meshes.
Vec3 local_origin(const Bounds& box) {
  const double diagonal = box.diagonal();
  Vec3 origin = Vec3::Zero();
  if (!(diagonal > 0.0)) return origin;
  const double step = std::exp2(std::floor(std::log2(diagonal)));
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = 0.5 * (box.low[axis] + box.high[axis]);
    if (std::abs(middle) > kFarAway * diagonal) origin[axis] = std::round(middle / step) * step;
  }
  return origin;
}

/// Vertices that are equal are joined first; near ones only if that leaves the surface unsound, so
/// that a sound mesh keeps its volume to the last digit.
/// @param weld_tolerance  share of the diagonal
TriangleMesh weld_as_needed(const TriangleMesh& raw, double weld_tolerance, RepairLog& log) {
  const double diagonal = bounds(raw).diagonal();
  TriangleMesh mesh = weld_vertices(raw, 0.0);
  reconstruct_detail::check_not_empty(mesh);
  MeshReport& as_read = log.report.as_read;
  as_read = inspect_mesh(mesh);
  const std::size_t vertices = mesh.vertices.size();
  double tolerance = 0.0;
  for (const double multiple : kWelds) {
    if (as_read.is_closed()) break;
    const double trial = multiple * weld_tolerance * diagonal;
    TriangleMesh joined = weld_vertices(raw, trial);
    const MeshReport report = inspect_mesh(joined);
    const std::size_t before = as_read.boundary_edges;
    const bool better =
        multiple == 1.0 ? report.boundary_edges < before : 2 * report.boundary_edges < before;
    // Vertices that lie close together because the mesh is fine are not torn apart.
    const bool only_borders = multiple == 1.0 || mesh.vertices.size() - joined.vertices.size() <=
                                                     kJoinedPerOpenEdge * before;
    if (report.triangles == 0 || !only_borders || !(report.is_closed() || better)) continue;
    mesh = std::move(joined);
    as_read = report;
    tolerance = trial;
  }
  log.area_as_read = surface_area(mesh);
  log.add_defect(DefectKind::kNearVertices, vertices - mesh.vertices.size(), 0.0, {}, tolerance);
  log.add_defect(DefectKind::kDegenerate, raw.triangles.size() - mesh.triangles.size());
  return mesh;
}

/// After this every edge has one triangle or two, and neighbours face the same way.
void repair_soup(TriangleMesh& mesh, bool fill_missing, RepairLog& log) {
  reconstruct_detail::SoupRepairResult repair;
  if (fill_missing) {
    repair = reconstruct_detail::repair_soup(mesh, reconstruct_detail::kMaxFinAreaFraction);
  } else {
    repair.removed_pairs = reconstruct_detail::remove_opposite_pairs(mesh);
    repair.orientation = reconstruct_detail::orient_consistently(mesh);
  }
  reconstruct_detail::check_not_empty(mesh);
  reconstruct_detail::check_orientable(mesh, repair.orientation, log);
  log.add_defect(DefectKind::kFoldedPair, repair.removed_pairs);
  log.add_defect(DefectKind::kFin, repair.removed_fins);
  log.add_defect(DefectKind::kNonManifoldEdge, repair.split_edges);
  std::size_t turned = repair.orientation.flipped;
  if (fill_missing) {
    turned += reconstruct_detail::orient_vertex_attached_fragments(mesh);
    log.report.holes = reconstruct_detail::retriangulate_missing_faces(mesh);
  }
  if (turned > 0) {
    log.add_defect(DefectKind::kInconsistentOrientation, turned, 0.0,
                   mesh.vertices[repair.orientation.first_flipped_vertex]);
  }
}

void fill_remaining_holes(TriangleMesh& mesh, const TriangleMesh& welded_mesh,
                          const RepairOptions& options, RepairLog& log) {
  std::vector<FilledHole>& holes = log.report.holes;
  for (const FilledHole& hole :
       reconstruct_detail::fill_holes_with_fans(mesh, reconstruct_detail::kMaxFanEdges)) {
    holes.push_back(hole);
  }
  if (options.fill_missing && inspect_mesh(mesh).boundary_edges > 0) {
    for (const FilledHole& hole : reconstruct_detail::fill_holes(mesh)) holes.push_back(hole);
  }
  const double area = surface_area(mesh);
  for (FilledHole& hole : holes) {
    hole.area_fraction = hole.area / area;
    log.report.filled_fraction += hole.area_fraction;
    log.report.volume_below += hole.volume_below;
    log.report.volume_above += hole.volume_above;
    reconstruct_detail::check_hole_size(hole, options.max_hole_fraction, welded_mesh, log);
  }
  std::stable_sort(holes.begin(), holes.end(),
                   [](const FilledHole& a, const FilledHole& b) { return a.area > b.area; });
  for (FilledHole& hole : holes) hole.centre = log.to_reported_frame(hole.centre);
}

/// Triangles that cross are replaced.
void replace_crossings(TriangleMesh& mesh, const Vec3& origin, RepairLog& log) {
  mesh = reconstruct_detail::snapped_to_grid(std::move(mesh), origin);
  const auto crossings = find_self_intersections(mesh);
  if (crossings.empty()) return;
  const Vec3 where = mesh.vertices[mesh.triangles[crossings[0][0]][0]];
  std::optional<reconstruct_detail::IntersectionFreeSurface> freed =
      reconstruct_detail::repair_self_intersections(mesh, origin);
  if (!freed) {
    throw GeometryError(
        "the surface passes through itself at " + std::to_string(crossings.size()) +
        " pairs of triangles, the first near " + log.format_position(where) +
        ", and these can't be removed without changing its volume by more than " +
        format_significant(100.0 * reconstruct_detail::kMaxIntersectionVolumeChange, 2) + " %" +
        reconstruct_detail::kRepairAdvice);
  }
  log.report.crossing_volume_change =
      std::abs(signed_volume(freed->mesh)) / std::abs(signed_volume(mesh)) - 1.0;
  log.report.relative_wrap_excess = freed->relative_wrap_excess;
  log.add_defect(DefectKind::kSelfIntersection, crossings.size(), 0.0, where);
  mesh = std::move(freed->mesh);
}

/// The largest component becomes closed and free of crossings.
void repair_block(TriangleMesh& mesh, const TriangleMesh& welded_mesh, const Vec3& origin,
                  const RepairOptions& options, RepairLog& log) {
  const RepairChange split = reconstruct_detail::split_non_manifold_vertices(mesh);
  const SpikeSummary first =
      options.fill_missing ? reconstruct_detail::flatten_spikes(mesh) : SpikeSummary{};
  fill_remaining_holes(mesh, welded_mesh, options, log);
  reconstruct_detail::check_closed(mesh, welded_mesh, log);
  const SpikeSummary second =
      options.fill_missing ? reconstruct_detail::flatten_spikes(mesh) : SpikeSummary{};
  log.add_defect(DefectKind::kNonManifoldVertex, split);
  const SpikeSummary& highest = first.max_height > second.max_height ? first : second;
  log.add_defect(DefectKind::kSpike, first.count + second.count, 0.0, highest.position,
                 highest.max_height);
  reconstruct_detail::check_volume(mesh);
  if (options.fill_missing) replace_crossings(mesh, origin, log);
}

void turn_solid_outward(TriangleMesh& mesh, RepairLog& log) {
  if (signed_volume(mesh) > 0.0) return;
  flip_orientation(mesh);
  log.flip_orientation();
  log.add_defect(DefectKind::kInwardOrientation, 1);
}

void note_tunnels(const TriangleMesh& mesh, RepairLog& log) {
  const MeshReport report = inspect_mesh(mesh);
  const long handles = static_cast<long>(report.components) - report.euler_characteristic / 2;
  if (handles > 0) log.add_defect(DefectKind::kTunnel, static_cast<std::size_t>(handles));
}

}  // namespace

void RepairOptions::check() const {
  if (!(weld_tolerance >= 0.0 && weld_tolerance <= 0.01)) {
    throw InputError("weld_tolerance = " + format_significant(weld_tolerance, 6) +
                     ": must be a fraction of the diagonal, between 0 and 0.01");
  }
  if (!(max_hole_fraction > 0.0 && max_hole_fraction < 1.0)) {
    throw InputError("largest_hole = " + format_significant(max_hole_fraction, 6) +
                     ": must be a fraction of the surface, between 0 and 1");
  }
}

RepairedMesh repair_mesh(const TriangleMesh& dirty, const RepairOptions& options) {
  options.check();
  reconstruct_detail::check_coordinates(dirty);
  const Vec3 origin = local_origin(bounds(dirty));
  TriangleMesh local = dirty;
  for (Vec3& v : local.vertices) v -= origin;
  RepairLog log(origin, options.to_reported_position);
  const TriangleMesh welded_mesh = weld_as_needed(local, options.weld_tolerance, log);
  TriangleMesh mesh = welded_mesh;
  repair_soup(mesh, options.fill_missing, log);
  std::vector<SurfaceComponent> components = reconstruct_detail::connected_components(mesh);
  reconstruct_detail::move_best_copy_first(components);
  mesh = std::move(components.front().mesh);
  reconstruct_detail::check_extent(mesh);
  repair_block(mesh, welded_mesh, origin, options, log);
  turn_solid_outward(mesh, log);
  reconstruct_detail::remove_other_components(mesh, components, options, log);
  note_tunnels(mesh, log);
  log.finish();
  for (Vec3& v : mesh.vertices) v += origin;
  return {std::move(mesh), std::move(log.report)};
}

}  // namespace clast
