#include "reconstruct/detail/cloud_blocks.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/cloud/separate_sets.hpp"
#include "reconstruct/detail/choose_block_on_ground.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/detail/deposit_blocks.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kMinPoints = 500;  ///< of a cloud
/// Points of a block from which its surface is reconstructed with all detail. With fewer, it is
/// segmented from the ground and estimated as a block of a deposit is.
constexpr std::size_t kDetailedPoints = 10000;

void refuse_unusable(const std::vector<Vec3>& points, const std::string& name, double unit) {
  if (!are_coordinates_valid(points, unit)) {
    throw InputError(name + ": a point is not finite or farther than " +
                     format_significant(kMaxCoordinate, 3) +
                     " m from the origin: the file is damaged, or its unit is wrong");
  }
  if (points.size() < kMinPoints) {
    throw InputError(name + ": no block: " + std::to_string(points.size()) +
                     " points are too few for a block; at least " + std::to_string(kMinPoints) +
                     " are needed");
  }
}

/// A ground would join what stands on it: without one, far sets are not of one block.
void refuse_separate_sets(const SeparatedPoints& found, const std::string& name) {
  if (found.far_area_ratio <= kMaxDebrisAreaFraction) return;
  throw GeometryError(
      name + ": separate sets of points, the second with about " +
      std::to_string(std::lround(100.0 * found.far_area_ratio)) +
      " % of the area of the first, near " + format_point(found.far_position) +
      "; save each block to a separate file, or delete the points of other objects");
}

/// Also notes what the surface leaves out and fills.
CloudSurface surface_of(const std::vector<Vec3>& points, const std::string& name,
                        const CloudSurfaceOptions& options, std::vector<std::string>& notes) {
  return with_error_context(name, [&] {
    CloudSurface surface = fit_cloud_surface(points, options);
    if (surface.outliers > 0) {
      notes.push_back(std::to_string(surface.outliers) +
                      " more points left out as outliers from the surface of their neighbours");
    }
    if (surface.gaps > 0) {
      notes.push_back(std::to_string(surface.gaps) + (surface.gaps == 1 ? " gap" : " gaps") +
                      " between the points filled, " +
                      format_significant(100.0 * surface.gap_fraction, 2) +
                      " % of the surface, the largest near " + format_point(surface.gap_position));
    }
    return surface;
  });
}

/// A block scanned without the ground around it.
FieldBlock block_alone(SeparatedPoints sets, std::vector<std::string> notes,
                       const std::string& name, const FieldScanOptions& options) {
  if (sets.far_count > 0) {
    notes.push_back(std::to_string(sets.far_count) +
                    " points far from the block were left out, some near " +
                    format_point(sets.far_position));
  }
  CloudSurface surface = surface_of(sets.near_points, name, options.surface, notes);
  return close_block({.surface = std::move(surface.mesh),
                      .uncertainty = &surface.uncertainty,
                      .notes = std::move(notes)},
                     name, options);
}

}  // namespace

CleanCloud clean_cloud(const std::vector<Vec3>& raw, const std::string& name, double unit) {
  refuse_unusable(raw, name, unit);
  CleanCloud clean;
  clean.first_duplicates = find_first_duplicates(raw);
  std::vector<std::uint32_t> unique;
  std::vector<Vec3> once;
  for (std::uint32_t i = 0; i < raw.size(); ++i) {
    if (clean.first_duplicates[i] != i) continue;
    unique.push_back(i);
    once.push_back(raw[i]);
  }
  for (const std::uint32_t i : find_non_isolated_points(once)) {
    clean.points.push_back(once[i]);
    clean.sources.push_back(unique[i]);
  }
  clean.notes.push_back("scan of " + std::to_string(raw.size()) + " points, " +
                        std::to_string(once.size() - clean.points.size()) + " of them outliers");
  if (once.size() < raw.size()) {
    clean.notes.push_back(std::to_string(raw.size() - once.size()) +
                          " duplicate points were left out");
  }
  return clean;
}

std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                             const FieldScanOptions& options) {
  CleanCloud clean = clean_cloud(raw, name, options.scan.unit);
  const std::vector<Vec3>& points = clean.points;
  std::vector<std::string>& notes = clean.notes;
  SeparatedPoints sets = separate_far_points(points);
  refuse_separate_sets(sets, name);
  std::optional<Ground> ground;
  if (options.find_ground) ground = find_ground(points);
  BlocksOnGround found;
  if (ground) found = find_blocks_on_ground(points, *ground);
  const std::size_t block_points = !ground ? points.size()
                                   : found.blocks.empty()
                                       ? 0
                                       : found.blocks[found.central_block].points.size();
  if (options.find_ground && block_points < kDetailedPoints) {
    std::optional<Vec3> normal;
    if (ground) normal = ground->plane().normal;
    if (std::optional<FieldBlock> block = extract_central_block(clean, normal, options)) {
      return {std::move(*block)};
    }
  }
  if (!ground) return {block_alone(std::move(sets), std::move(notes), name, options)};

  if (found.blocks.empty()) {
    throw_only_ground_error(
        name, static_cast<double>(found.ground.size()) / static_cast<double>(points.size()));
  }
  const ChosenBlock chosen = choose_block_on_ground(points, *ground, found);
  notes.insert(notes.end(), chosen.notes.begin(), chosen.notes.end());
  std::vector<std::string> own_notes;
  CloudSurface surface = surface_of(chosen.points, name, options.surface, own_notes);
  FieldBlock block = close_block({.surface = std::move(surface.mesh),
                                  .ground = chosen.ground,
                                  .centre = chosen.centre,
                                  .uncertainty = &surface.uncertainty,
                                  .notes = notes},
                                 name, options);
  block.scan.notes.insert(block.scan.notes.end(), own_notes.begin(), own_notes.end());
  return {std::move(block)};
}

}  // namespace clast::reconstruct_detail
