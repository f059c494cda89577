#include "reconstruct/detail/close_block.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "reconstruct/detail/shape_anomalies.hpp"
#include "reconstruct/repair/holes.hpp"
#include "reconstruct/underside/noted_bounds.hpp"
#include "shapes/oriented_box.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kMinHoleArea = 1e-9;  ///< of the area: every hole is closed and reported
/// An open scan of which less than this share is filled in was closed by other means before.
constexpr double kHardlyOpen = 0.01;
constexpr double kNotedTilt = 1.0;  ///< degrees; a turn by less is not noted

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegreesPerRadian;
}

/// Converts from metres, z up, to the units and axes of the file.
TriangleMesh in_file_units(TriangleMesh mesh, const ScanOptions& options) {
  for (Vec3& v : mesh.vertices) {
    v = (options.up == "y" ? z_up_to_y_up(v) : v) / options.unit;
  }
  return mesh;
}

/// True if little surface was missing, but more than a fan closes.
bool hardly_open(const FieldBlock& block) {
  if (block.underside) return block.underside->filled_fraction < kHardlyOpen;
  const RepairReport& report = block.scan.report;
  return report.filled_fraction < kHardlyOpen &&
         std::any_of(report.holes.begin(), report.holes.end(),
                     [](const FilledHole& hole) { return hole.border_edges > kMaxFanEdges; });
}

/// Adds a note if hardly any surface was missing.
FieldBlock with_doubt(FieldBlock block) {
  if (hardly_open(block)) {
    block.scan.notes.push_back(
        "little surface was missing, so the bounds are narrow; the file does not show whether the "
        "scanning software had already closed an unscanned side, such as the bottom: "
        "check the volume by weighing (`mass` with `density`)");
  }
  return block;
}

/// True if repair changed a part of the surface. False for wraps, which change all of it.
bool was_changed(const RepairReport& report) {
  return !report.relative_wrap_excess &&
         (report.filled_fraction > 0.0 || !report.duplicates.empty() ||
          report.find_defect(DefectKind::kSpike) != nullptr ||
          report.find_defect(DefectKind::kSelfIntersection) != nullptr);
}

/// Flips a mesh that faces inwards, judging by the volume with its largest hole filled flat.
/// @returns whether it faced inwards
bool turn_open_mesh_outward(TriangleMesh& open) {
  const std::vector<std::vector<std::uint32_t>> loops = boundary_loops(open);
  if (loops.empty()) return false;
  const auto& largest = *std::max_element(
      loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t v : largest) {
    middle += open.vertices[v] / static_cast<double>(largest.size());
  }
  double sixfold = 0.0;
  for (const auto& [a, b, c] : open.triangles) {
    sixfold += (open.vertices[a] - middle)
                   .dot((open.vertices[b] - middle).cross(open.vertices[c] - middle));
  }
  if (sixfold >= 0.0) return false;
  flip_orientation(open);
  return true;
}

/// The report of the same surface turned over.
void flip_orientation(RepairReport& report) {
  std::swap(report.volume_below, report.volume_above);
  for (FilledHole& hole : report.holes) std::swap(hole.volume_below, hole.volume_above);
  for (DuplicateSurface& copy : report.duplicates) {
    copy.offset = -copy.offset;
    copy.volume_change = -copy.volume_change;
  }
}

/// Closes all holes but the unobserved side. Holes of clouds lack points, so only those with few
/// edges are closed.
std::vector<FilledHole> close_small_holes(OpenBlock& open, const std::string& name) {
  if (open.uncertainty != nullptr) return fill_holes_with_fans(open.surface, kMaxFanEdges);
  return with_error_context(name, [&] { return fill_holes(open.surface, false); });
}

/// Returns the scanned part of the surface; null if there are no other parts.
std::unique_ptr<const ScannedSurface> scanned_part(const OpenBlock& open) {
  if (open.uncertainty != nullptr) {
    return std::make_unique<ScannedSurface>(std::span<const Vec3>(open.surface.vertices));
  }
  if (was_changed(open.repaired)) return std::make_unique<ScannedSurface>(*open.raw);
  return nullptr;
}

std::optional<Underside> close_unseen_side(const OpenBlock& open, const ScannedSurface* scanned,
                                           const std::string& name, const FreeSpaceGrid* free_space,
                                           double unit) {
  UndersideOptions closing{
      .ground = open.ground, .min_hole_fraction = kMinHoleArea, .free_space = free_space};
  if (scanned)
    closing.is_observed = [&](const Vec3& position) { return scanned->contains(position); };
  closing.uncertainty = open.uncertainty;
  closing.unit = unit;
  return with_error_context(name, [&] { return close_underside(open.surface, closing); });
}

/// The turn about the place where the block stands after which z points up from its ground.
Pose upright(const OpenBlock& open, const ScanOptions& options) {
  const Vec3 normal = in_metres(open.ground->normal, options).normalized();
  const Vec3 pivot = in_metres(open.centre, options);
  const Quat rotation = Quat::FromTwoVectors(normal, Vec3::UnitZ());
  return {pivot - rotation * pivot, rotation};
}

/// The same underside with every length scaled and every place moved.
template <class Move>
Underside moved(Underside side, double unit, const Move& move) {
  for (TriangleMesh* mesh : {&side.lower_mesh, &side.best_estimate}) {
    for (Vec3& vertex : mesh->vertices) vertex = move(vertex);
  }
  static_cast<VolumeBracket&>(side) = scaled(side, unit);
  const Vec3 centre = move(side.rim_centre);
  side.down = (move(side.rim_centre + side.down) - centre).normalized();
  side.rim_centre = centre;
  side.rim_length *= unit;
  side.ground_clearance *= unit;
  return side;
}

/// A place of the block as it is in the file, to 1e-4 of the block's size.
std::string format_file_place(const Vec3& point, const FieldBlock& block,
                              const ScanOptions& options) {
  const double digit = std::pow(
      10.0, std::floor(std::log10(1e-3 * bounds(block.scan.mesh).diagonal() / options.unit)));
  const Vec3 upright = block.block_from_file.inverse() * point;
  const Vec3 in_file = (options.up == "y" ? z_up_to_y_up(upright) : upright) / options.unit;
  return format_point(((in_file / digit).array().round() * digit + 0.0).matrix());  // no "-0"
}

/// States the bounds of a block without an unseen side, if they are worth it.
void add_bounds(FieldBlock& block, const ClosedScan& closed) {
  const std::optional<VolumeBracketWithNotes> bounds =
      compute_closed_scan_bracket(closed, block.scan.report);
  if (!bounds) return;
  block.bounds = *bounds;
  block.scan.notes.insert(block.scan.notes.end(), bounds->notes.begin(), bounds->notes.end());
}

/// A neighbour with more of the volume than this is refused: either body may be the block.
constexpr double kSmallNeighbour = 0.06;

/// Lowers the bounds to those of the block without what lies beyond a seam.
/// @param fraction  of the volume that lies there
void leave_out_neighbour(FieldBlock& block, const Plane& seam, double fraction) {
  const std::vector<Vec3>& whole = block.scan.mesh.vertices;
  if (!block.bounds) {
    const double volume = signed_volume(block.scan.mesh);
    const Vec3 sides = smallest_box(whole).lengths;
    block.bounds = VolumeBracket{volume, volume, volume, BoxSideBounds{sides, sides}};
  }
  block.bounds->lower_volume *= 1.0 - fraction;
  if (!block.bounds->sides) return;
  std::vector<Vec3> alone;
  std::copy_if(whole.begin(), whole.end(), std::back_inserter(alone),
               [&](const Vec3& vertex) { return seam.signed_distance(vertex) <= 0.0; });
  const Vec3 shrinks =
      smallest_box(alone).lengths.cwiseQuotient(smallest_box(whole).lengths).cwiseMin(1.0);
  block.bounds->sides->lower = block.bounds->sides->lower.cwiseProduct(shrinks);
}

/// Notes what makes the form of a block doubtful.
/// @param on_ground  then a seam is that of a neighbour: a small one widens the bounds, others are
///                   refused
void judge_form(FieldBlock& block, const std::string& name, const ScanOptions& options,
                bool on_ground) {
  const auto format_file_position = [&](const Vec3& point) {
    return format_file_place(point, block, options);
  };
  for (const ShapeAnomaly& anomaly : find_shape_anomalies(block.scan.mesh)) {
    if (!on_ground || anomaly.kind != ShapeAnomaly::Kind::kSeam) {
      block.scan.notes.push_back(format_shape_anomaly(anomaly, format_file_position));
      continue;
    }
    const std::string seam = " in a seam " + format_significant(anomaly.size, 2) + " m wide near " +
                             format_file_position(anomaly.position);
    const std::string percent =
        format_significant(100.0 * anomaly.fraction, 2) + " % of the volume";
    if (anomaly.fraction > kSmallNeighbour) {
      throw GeometryError(name + ": two bodies that touch" + seam + ", the smaller with " +
                          percent +
                          ": crop the scan to one of them; if it is one rock with a narrow "
                          "middle, crop the ground off the scan and give `find_ground = false`");
    }
    leave_out_neighbour(block, *anomaly.seam, anomaly.fraction);
    block.scan.notes.push_back(
        "a smaller body with " + percent + " touches this one" + seam +
        "; the lower bounds exclude it; crop it from the scan to narrow the bounds");
  }
}

}  // namespace

Vec3 in_metres(Vec3 point, const ScanOptions& options) {
  point *= options.unit;
  return options.up == "y" ? y_up_to_z_up(point) : point;
}

void note_tilt(const Quat& rotation, std::vector<std::string>& notes) {
  const double tilt = degrees_between(rotation * Vec3::UnitZ(), Vec3::UnitZ());
  if (tilt <= kNotedTilt) return;
  notes.push_back("turned by " + format_significant(tilt, 3) +
                  " degrees so that z points up from the ground; `up` keeps the axes of the file");
}

FieldBlock close_block(OpenBlock open, const std::string& name, const FieldScanOptions& field) {
  const ScanOptions& options = field.scan;
  if (turn_open_mesh_outward(open.surface)) flip_orientation(open.repaired);
  const std::vector<FilledHole> filled = close_small_holes(open, name);
  open.repaired = report_with_fillings(std::move(open.repaired), filled, surface_area(open.surface),
                                       options.unit);
  const std::unique_ptr<const ScannedSurface> scanned = scanned_part(open);
  std::optional<Underside> side =
      close_unseen_side(open, scanned.get(), name, field.free_space, options.unit);
  std::optional<Pose> upright_pose;
  if (open.ground && !field.up_given) upright_pose = upright(open, options);
  FieldBlock block{
      clean_scan(side ? side->best_estimate : open.surface, name, options, upright_pose), {}, {}};
  if (upright_pose) block.block_from_file = *upright_pose;
  RepairReport& report = block.scan.report;
  report = merged(std::move(open.repaired), std::move(report));
  std::vector<std::string>& notes = block.scan.notes;
  notes = describe_repairs(report);
  notes.insert(notes.begin(), open.notes.begin(), open.notes.end());
  if (!side) {
    add_bounds(block, {open.surface, options.unit, scanned.get(), open.uncertainty});
  }
  if (upright_pose) note_tilt(upright_pose->rotation, notes);
  if (side) {
    notes.insert(notes.end(), side->notes.begin(), side->notes.end());
    block.underside = moved(std::move(*side), options.unit, [&](const Vec3& p) {
      return block.block_from_file * in_metres(p, options);
    });
    block.bounds = compute_underside_bracket(*block.underside, report);
  }
  judge_form(block, name, options, open.ground.has_value());
  return with_doubt(std::move(block));
}

FieldBlock clean_block(const TriangleMesh& raw, const std::string& name,
                       const FieldScanOptions& field) {
  FieldBlock block{clean_scan(raw, name, field.scan), {}, {}};
  if (was_changed(block.scan.report)) {
    const ScannedSurface scanned(raw);
    const TriangleMesh closed = in_file_units(block.scan.mesh, field.scan);
    add_bounds(block, {closed, field.scan.unit, &scanned, nullptr});
  }
  judge_form(block, name, field.scan, false);
  return with_doubt(std::move(block));
}

RepairReport report_with_fillings(RepairReport report, const std::vector<FilledHole>& fillings,
                                  double area, double unit) {
  if (fillings.empty()) return report;
  RepairReport filled;
  double area_fraction = 0.0;
  for (FilledHole hole : fillings) {
    hole.area_fraction = hole.area / area;
    area_fraction += hole.area_fraction;
    hole.perimeter *= unit;
    hole.radius *= unit;
    hole.area *= unit * unit;
    hole.volume_below *= unit * unit * unit;
    hole.volume_above *= unit * unit * unit;
    filled.volume_below += hole.volume_below;
    filled.volume_above += hole.volume_above;
    filled.filled_fraction += hole.area_fraction;
    filled.holes.push_back(hole);
  }
  std::stable_sort(filled.holes.begin(), filled.holes.end(),
                   [](const FilledHole& a, const FilledHole& b) { return a.area > b.area; });
  filled.defects.push_back({DefectKind::kHole, fillings.size(), area_fraction,
                            filled.holes[0].radius, filled.holes[0].centre});
  return merged(std::move(report), std::move(filled));
}

bool are_coordinates_valid(const std::vector<Vec3>& points, double unit) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() * unit <= kMaxCoordinate &&
           p.cwiseAbs().maxCoeff() <= kMaxCoordinate;
  });
}

}  // namespace clast::reconstruct_detail
