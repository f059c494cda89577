#include "reconstruct/detail/deposit_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"
#include "mesh/surface_samples.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/detail/choose_block_on_ground.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/detail/cloud_blocks.hpp"
#include "reconstruct/detail/mesh_blocks.hpp"
#include "shapes/convex_outline.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Smallest blocks that a scan resolves, in point spacings.
constexpr double kResolvedSpacings = 8.0;

/// Decay of the preference for blocks near the middle, at the corner of the scan.
constexpr double kCentreDecay = 4.0;
/// Strip of ground around a block that dominates its scan: least fraction of the points, and
/// largest diagonal over that of the block.
constexpr double kLeastGround = 0.05, kMaxSurroundings = 2.5;

constexpr double kFarthestStation = 50.0;  ///< from the points, in diagonals of the scan

constexpr std::size_t kMinSurfaceSamples = 60000;  ///< of a mesh

std::string list_contacts(const std::vector<std::uint32_t>& contacts) {
  std::string list;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == contacts.size() ? " and " : ", ");
    list += std::to_string(contacts[i] + 1);
  }
  return list;
}

/// Sizes of the blocks that a scan resolves, as the end of a sentence.
std::string describe_resolution(std::size_t points, double spacing) {
  return std::to_string(points) + " points with a spacing of " + format_significant(spacing, 2) +
         " m show blocks from about " + format_significant(kResolvedSpacings * spacing, 2) + " m";
}

/// States why there is no block, to follow "no part of the scan is a block", and what to do.
std::string explain_no_block(const Deposit& deposit, std::size_t points) {
  const std::vector<LeftOutPart>& parts = deposit.left_out;
  const auto largest = std::max_element(
      parts.begin(), parts.end(),
      [](const LeftOutPart& a, const LeftOutPart& b) { return a.points < b.points; });
  std::string text;
  if (largest != parts.end()) {
    text = " (" + format_count(parts.size(), "part") +
           " left out, the largest because of: " + name_of(largest->reason) + ")";
    if (largest->reason == LeftOutReason::kTooSmall) return text + "; give a lower limit";
  }
  return text + "; " + describe_resolution(points, deposit.spacing) +
         "; check that z points up (`up`), scan more densely, or, if this is one block alone, "
         "leave `split` out";
}

/// True if a block dominates the scan, with a strip of ground around it: all points are near it,
/// and enough of them lie outside its outline in plan.
bool has_strip_of_ground(const std::vector<Vec3>& points, const DepositBlock& block) {
  std::vector<Vec2> plan;
  Bounds own, all;
  for (const Vec3& p : points) all.include(p);
  for (const std::uint32_t i : block.points) {
    own.include(points[i]);
    plan.emplace_back(points[i].head<2>());
  }
  if (all.diagonal() > kMaxSurroundings * own.diagonal()) return false;
  const std::vector<Vec2> outline = convex_hull_2d(std::move(plan));
  const auto outside = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
      if (twice_area(outline[k], outline[(k + 1) % outline.size()], p.head<2>()) < 0.0) return true;
    }
    return false;
  });
  return static_cast<double>(outside) > kLeastGround * static_cast<double>(points.size());
}

/// Converts the stations of the scan to metres.
/// @throws InputError  if one is so far from the points that its coordinates are of another system
std::vector<Vec3> find_stations(const std::vector<Vec3>& points, const std::string& name,
                                const FieldScanOptions& options) {
  Bounds extent;
  for (const Vec3& p : points) extent.include(p);
  std::vector<Vec3> stations;
  for (const Vec3& given : options.stations) {
    stations.push_back(in_metres(given, options.scan));
    const Vec3& station = stations.back();
    const double distance = (station - station.cwiseMax(extent.low).cwiseMin(extent.high)).norm();
    if (distance <= kFarthestStation * extent.diagonal()) continue;
    throw InputError(name + ": position " + std::to_string(stations.size()) + " of `stations`, " +
                     format_point(given) + ", is " + format_significant(distance, 3) +
                     " m from the points, which extend over " +
                     format_significant(extent.diagonal(), 3) +
                     " m; give positions in the coordinates of the scan");
  }
  return stations;
}

FieldBlock field_block(DepositBlock block, const std::vector<std::string>& notes) {
  FieldBlock found;
  found.scan.mesh = std::exchange(block.body, {});
  found.scan.notes = notes;
  found.scan.notes.push_back(format_significant(100.0 * block.visible_fraction, 2) +
                             " % of its surface is visible, with " +
                             std::to_string(block.points.size()) +
                             " points; the rest is estimated");
  if (!block.contacts.empty()) {
    found.scan.notes.push_back((block.contacts.size() == 1 ? "touches block " : "touches blocks ") +
                               list_contacts(block.contacts) + " of this scan");
  }
  found.bounds = std::exchange(block.bounds, {});
  found.in_deposit = std::move(block);
  return found;
}

}  // namespace

FieldDeposit extract_deposit(const std::vector<Vec3>& raw, const std::string& name,
                             const FieldScanOptions& options) {
  CleanCloud clean = clean_cloud(raw, name, options.scan.unit);
  for (Vec3& p : clean.points) p = in_metres(p, options.scan);
  std::vector<Vec3> stations = find_stations(clean.points, name, options);
  Deposit deposit = segment_deposit(clean.points, {.smallest_axis = options.smallest_axis,
                                                   .edits = options.edits,
                                                   .stations = std::move(stations),
                                                   .threads = options.surface.threads,
                                                   .progress = options.progress});
  if (deposit.blocks.empty()) {
    throw GeometryError(name + ": no part of the scan is a block" +
                        explain_no_block(deposit, raw.size()));
  }
  FieldDeposit found;
  found.notes = clean.notes;
  const double resolved = kResolvedSpacings * deposit.spacing;
  if (options.smallest_axis > 0.0 && options.smallest_axis < resolved) {
    found.notes.push_back("`smallest_axis` is " + format_significant(options.smallest_axis, 4) +
                          " m, but " + describe_resolution(raw.size(), deposit.spacing) +
                          "; smaller ones need a spacing of " +
                          format_significant(options.smallest_axis / kResolvedSpacings, 2) + " m");
  }
  found.left_out = std::move(deposit.left_out);
  found.spacing = deposit.spacing;
  found.block_of_point.assign(raw.size(), 0);
  for (std::size_t b = 0; b < deposit.blocks.size(); ++b) {
    for (std::uint32_t& i : deposit.blocks[b].points) {
      i = static_cast<std::uint32_t>(clean.sources[i]);
      found.block_of_point[i] = static_cast<std::uint32_t>(b + 1);
    }
    found.blocks.push_back(field_block(std::move(deposit.blocks[b]), {}));
  }
  for (std::size_t i = 0; i < raw.size(); ++i) {
    found.block_of_point[i] = found.block_of_point[clean.first_duplicates[i]];
  }
  return found;
}

FieldDeposit extract_deposit(const TriangleMesh& raw, const std::string& name,
                             const FieldScanOptions& options) {
  FieldDeposit found;
  if (is_closed_body(raw, options.scan)) {
    if (!options.edits.empty()) {
      throw InputError(name +
                       ": the mesh is a closed body, hence one block, which `edits` cannot "
                       "change; leave them out");
    }
    found.blocks = extract_mesh_blocks(raw, name, options);
    found.block_of_point.assign(raw.vertices.size(), 1);
    return found;
  }
  const std::vector<Vec3> points =
      sample_surface(raw, std::max(kMinSurfaceSamples, raw.vertices.size()));
  found = extract_deposit(points, name, options);
  const PointTree tree(points);
  std::vector<std::uint32_t> block_of_vertex;
  for (const Vec3& vertex : raw.vertices) {
    block_of_vertex.push_back(
        found.block_of_point[tree.nearest_neighbours(vertex, 1).front().point]);
  }
  found.block_of_point = std::move(block_of_vertex);
  found.spacing *=
      std::sqrt(static_cast<double>(points.size()) / static_cast<double>(raw.vertices.size()));
  return found;
}

std::optional<FieldBlock> extract_central_block(const CleanCloud& cloud,
                                                const std::optional<Vec3>& ground_normal,
                                                const FieldScanOptions& options) {
  Pose upright{Vec3::Zero(), Quat::Identity()};
  if (ground_normal && !options.up_given) {
    upright.rotation = Quat::FromTwoVectors(in_metres(*ground_normal, options.scan), Vec3::UnitZ());
  }
  std::vector<Vec3> points;
  Bounds extent;
  for (const Vec3& p : cloud.points) {
    points.push_back(upright * in_metres(p, options.scan));
    extent.include(points.back());
  }
  Deposit deposit = segment_deposit(points, {.threads = options.surface.threads});
  const Vec3 middle = 0.5 * (extent.low + extent.high);
  const double half = 0.5 * (extent.high - extent.low).head<2>().norm();
  DepositBlock* chosen = nullptr;
  double most = 0.0;
  for (DepositBlock& block : deposit.blocks) {
    const double distance = (block.centre - middle).head<2>().norm() / half;
    const double weight =
        std::cbrt(signed_volume(block.body)) * std::exp(-kCentreDecay * distance * distance);
    if (weight <= most) continue;
    most = weight;
    chosen = &block;
  }
  if (!chosen) return {};
  const bool is_alone = deposit.blocks.size() == 1 && deposit.left_out.empty();
  if (!ground_normal && !(is_alone && has_strip_of_ground(points, *chosen))) {
    return {};
  }
  chosen->contacts.clear();
  for (std::uint32_t& i : chosen->points) i = cloud.sources[i];
  std::vector<std::string> notes = cloud.notes;
  notes.push_back("the ground around it was found and removed");
  if (deposit.blocks.size() > 1) notes.push_back(note_other_blocks(deposit.blocks.size()));
  note_tilt(upright.rotation, notes);
  FieldBlock block = field_block(std::move(*chosen), notes);
  block.block_from_file = upright;
  return block;
}

}  // namespace clast::reconstruct_detail
