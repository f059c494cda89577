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
#include "reconstruct/registration/passes.hpp"

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

/// Largest error of the volume, relative to that of the layer between the two surfaces.
constexpr double kMisfitVolume = 0.5;

/// Widens the bounds of a surface through passes that do not fit.
void add_misfit(const PassMisfit& misfit, const TriangleMesh& mesh,
                SurfaceUncertainty& uncertainty) {
  const double volume = kMisfitVolume * misfit.distance * surface_area(mesh);
  uncertainty.volume_below += volume;
  uncertainty.volume_above += volume;
  uncertainty.extent_error += misfit.shift.norm();
}

std::string note_misfit(const PassMisfit& misfit, double unit) {
  return "its passes do not fit: " + describe_misfit(misfit, unit) + "; `align` does this";
}

/// A block scanned without the ground around it.
FieldBlock block_alone(SeparatedPoints sets, const std::optional<PassMisfit>& misfit,
                       std::vector<std::string> notes, const std::string& name,
                       const FieldScanOptions& options) {
  if (sets.far_count > 0) {
    notes.push_back(std::to_string(sets.far_count) +
                    " points far from the block were left out, some near " +
                    format_point(sets.far_position));
  }
  CloudSurface surface = surface_of(sets.near_points, name, options.surface, notes);
  if (misfit) add_misfit(*misfit, surface.mesh, surface.uncertainty);
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

namespace {

/// Points of the block near the middle, and the ground around it.
struct FoundBlock {
  SeparatedPoints sets;
  std::optional<Ground> ground = {};
  BlocksOnGround on_ground = {};
};

std::vector<FieldBlock> make_found_block(const CleanCloud& clean, FoundBlock found,
                                         const std::optional<PassMisfit>& misfit,
                                         std::vector<std::string> notes, const std::string& name,
                                         const FieldScanOptions& options) {
  const std::vector<Vec3>& points = clean.points;
  const std::optional<Ground>& ground = found.ground;
  const std::vector<BlockOnGround>& blocks = found.on_ground.blocks;
  const std::size_t block_points = !ground ? points.size()
                                   : blocks.empty()
                                       ? 0
                                       : blocks[found.on_ground.central_block].points.size();
  if (options.find_ground && block_points < kDetailedPoints) {
    std::optional<Vec3> normal;
    if (ground) normal = ground->plane().normal;
    if (std::optional<FieldBlock> block = extract_central_block(clean, normal, options)) {
      if (misfit) block->scan.notes.push_back(note_misfit(*misfit, options.scan.unit));
      return {std::move(*block)};
    }
  }
  if (!ground) {
    return {block_alone(std::move(found.sets), misfit, std::move(notes), name, options)};
  }
  if (blocks.empty()) {
    throw_only_ground_error(name, static_cast<double>(found.on_ground.ground.size()) /
                                      static_cast<double>(points.size()));
  }
  const ChosenBlock chosen = choose_block_on_ground(points, *ground, found.on_ground);
  notes.insert(notes.end(), chosen.notes.begin(), chosen.notes.end());
  std::vector<std::string> own_notes;
  CloudSurface surface = surface_of(chosen.points, name, options.surface, own_notes);
  if (misfit) add_misfit(*misfit, surface.mesh, surface.uncertainty);
  FieldBlock block = close_block({.surface = std::move(surface.mesh),
                                  .ground = chosen.ground,
                                  .centre = chosen.centre,
                                  .uncertainty = &surface.uncertainty,
                                  .notes = notes},
                                 name, options);
  block.scan.notes.insert(block.scan.notes.end(), own_notes.begin(), own_notes.end());
  return {std::move(block)};
}

}  // namespace

std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                             const FieldScanOptions& options) {
  CleanCloud clean = clean_cloud(raw, name, options.scan.unit);
  const std::vector<Vec3>& points = clean.points;
  std::vector<std::string>& notes = clean.notes;
  FoundBlock found{separate_far_points(points)};
  refuse_separate_sets(found.sets, name);
  if (options.find_ground) found.ground = find_ground(points);
  std::vector<Vec3> of_block = found.sets.near_points;
  if (found.ground) {
    found.on_ground = find_blocks_on_ground(points, *found.ground);
    of_block.clear();
    if (!found.on_ground.blocks.empty()) {
      of_block = choose_block_on_ground(points, *found.ground, found.on_ground).points;
    }
  }
  std::optional<PassMisfit> misfit = find_pass_misfit(of_block);
  if (!misfit) return make_found_block(clean, std::move(found), misfit, notes, name, options);
  const std::string note = note_misfit(*misfit, options.scan.unit);
  notes.insert(notes.begin(), note);
  return with_rewritten_error(
      [&](const std::string& message) { return message + " (" + note + ")"; },
      [&] { return make_found_block(clean, std::move(found), misfit, notes, name, options); });
}

}  // namespace clast::reconstruct_detail
