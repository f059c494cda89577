#include "reconstruct/detail/block_points.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/statistics/statistics.hpp"
#include "reconstruct/cloud/cut_out.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/cloud/separate_sets.hpp"
#include "reconstruct/detail/choose_block_on_ground.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/detail/cloud_blocks.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Height above the ground below which points may be of the block or of the ground, in standard
/// deviations of the ground and in spacings of the points.
constexpr double kFootDeviations = 2.5, kFootSpacings = 0.5;

}  // namespace

BlockPoints extract_block_points(const TriangleMesh& raw, const std::string& name,
                                 const FieldScanOptions& options, FootPoints foot_points) {
  CleanCloud clean = clean_cloud(raw.triangles.empty() ? raw.vertices : sample_surface_points(raw),
                                 name, options.scan.unit);
  for (Vec3& p : clean.points) p = in_metres(p, options.scan);
  BlockPoints block;
  if (raw.triangles.empty()) block.notes = clean.notes;
  std::optional<Ground> ground;
  if (options.find_ground) ground = find_ground(clean.points);
  if (!ground) {
    SeparatedPoints sets = separate_far_points(clean.points);
    if (sets.far_area_ratio > kMaxDebrisAreaFraction) {
      throw GeometryError(name +
                          ": separate sets of points, and no ground that joins them; crop "
                          "the scan to the block");
    }
    block.points = std::move(sets.near_points);
    std::size_t next = 0;  // the points left over are in the same order
    for (const Vec3& p : block.points) {
      while (clean.points[next] != p) ++next;
      block.sources.push_back(clean.sources[next]);
    }
    return block;
  }
  const BlocksOnGround found = find_blocks_on_ground(clean.points, *ground);
  if (found.blocks.empty()) {
    throw_only_ground_error(
        name, static_cast<double>(found.ground.size()) / static_cast<double>(clean.points.size()));
  }
  ChosenBlock chosen = choose_block_on_ground(clean.points, *ground, found);
  const bool keeps_foot = foot_points == FootPoints::kKept;
  const double foot = kFootDeviations * ground->roughness() +
                      kFootSpacings * upper_median(compute_local_spacings(chosen.points));
  for (std::size_t i = 0; i < chosen.points.size(); ++i) {
    const Vec3& p = chosen.points[i];
    if (!keeps_foot && ground->height_above_ground(p) <= foot) continue;
    block.points.push_back(p);
    block.sources.push_back(clean.sources[chosen.point_indices[i]]);
  }
  block.ground = chosen.ground;
  block.centre = chosen.centre;
  block.notes.insert(block.notes.end(), chosen.notes.begin(), chosen.notes.end());
  return block;
}

}  // namespace clast::reconstruct_detail
