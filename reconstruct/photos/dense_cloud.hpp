#pragma once
/// Points on the block and the ground about it, from photos with cameras.
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/stereo_pairs.hpp"
#include "reconstruct/underside/free_space_grid.hpp"

namespace clast {

struct DenseOptions {
  StereoPairOptions pairs = {};
  int most_pixels = 1100;  ///< sides of the compared parts of photos; larger ones are reduced
  std::size_t min_agreeing_pairs = 3;  ///< depths from as many pairs must meet in a point
  double tolerance = 1.0;              ///< px, by which they may differ
  double cell = 1.7;  ///< one point per cube of this many pixels' width on the block
  bool skip_blurred = true;
  /// Folder of masks, as `find_masks` takes them, or empty.
  std::filesystem::path masks = {};
  unsigned threads = 0;  ///< 0: one per core; the results are the same for any number

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const DenseOptions& options, Visit&& visit) {
  const auto& [pairs, most_pixels, min_agreeing_pairs, tolerance, cell, skip_blurred, masks,
               threads] = options;
  visit("pairs", pairs);
  visit("most_pixels", most_pixels);
  visit("agreeing", min_agreeing_pairs);
  visit("tolerance", tolerance);
  visit("cell", cell);
  visit("skip_blurred", skip_blurred);
  visit("masks", masks);
  visit("threads", ExcludedField{threads});
}

struct DenseCloud {
  std::vector<Vec3> points;                          ///< in the frame and units of the model
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< red, green, blue
  FreeSpaceGrid free_space;  ///< space of the region that photos looked through
  PhotoRegion region;
  std::vector<StereoPair> pairs;
  std::vector<std::size_t> blurred;  ///< numbers of photos that were skipped
  double cell = 0.0;                 ///< of the points, in units of the model
  std::vector<std::string> notes;
};

/// Compares neighbouring photos, and keeps the points that several pairs agree on and that no more
/// pairs see through; each is the mean of what they say. See docs/theory.md.
/// @param model     with files
/// @param progress  called with what was done of what there is to do, from one thread at a time
/// @throws InputError  what `stereo_pairs` throws; masks that are missing; photos that don't agree
DenseCloud compute_dense_cloud(const PhotoModel& model, const DenseOptions& options = {},
                               const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace clast
