#include "reconstruct/detail/cloud_blocks.hpp"

#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/cloud/separate_sets.hpp"
#include "reconstruct/detail/choose_blocks_on_ground.hpp"
#include "reconstruct/detail/close_block.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kMinPoints = 500;  ///< of a cloud

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

/// The points without repeats and outliers; notes how many these are.
std::vector<Vec3> clean_points(const std::vector<Vec3>& raw, std::vector<std::string>& notes) {
  std::vector<Vec3> points;
  const std::vector<Vec3> once = remove_duplicate_points(raw);
  for (const std::uint32_t i : find_non_isolated_points(once)) points.push_back(once[i]);
  notes.push_back("made from " + std::to_string(raw.size()) + " points, " +
                  std::to_string(once.size() - points.size()) + " of them outliers");
  if (once.size() < raw.size()) {
    notes.push_back(std::to_string(raw.size() - once.size()) + " duplicate points were left out");
  }
  return points;
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

std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                             const FieldScanOptions& options) {
  refuse_unusable(raw, name, options.scan.unit);
  std::vector<std::string> notes;
  const std::vector<Vec3> points = clean_points(raw, notes);
  SeparatedPoints sets = separate_far_points(points);
  refuse_separate_sets(sets, name);
  std::optional<Ground> ground;
  if (options.find_ground) ground = find_ground(points);
  if (!ground) return {block_alone(std::move(sets), std::move(notes), name, options)};

  const ChosenBlocks chosen = choose_blocks_on_ground(points, *ground, name, options.split);
  notes.insert(notes.end(), chosen.notes.begin(), chosen.notes.end());
  std::vector<FieldBlock> blocks;
  for (const ChosenBlock& block : chosen.blocks) {
    std::vector<std::string> own_notes;
    CloudSurface surface = surface_of(block.points, name, options.surface, own_notes);
    blocks.push_back(close_block({.surface = std::move(surface.mesh),
                                  .ground = block.ground,
                                  .centre = block.centre,
                                  .uncertainty = &surface.uncertainty,
                                  .notes = notes},
                                 name, options));
    std::vector<std::string>& all = blocks.back().scan.notes;
    all.insert(all.end(), own_notes.begin(), own_notes.end());
  }
  return blocks;
}

}  // namespace clast::reconstruct_detail
