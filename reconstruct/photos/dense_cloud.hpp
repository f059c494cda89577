#pragma once
/// Dense point cloud from photos with cameras.
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
  int max_image_side =
      1100;  ///< maximum side of the compared image regions, px; larger ones are scaled down
  std::size_t min_agreeing_pairs = 3;  ///< minimum number of pairs with consistent depths per point
  double tolerance = 1.0;              ///< maximum disparity difference of consistent depths, px
  double cell = 1.7;  ///< point spacing at the block, in pixels of the compared photos
  bool skip_blurred = true;
  /// Folder of masks (`find_masks`), or empty.
  std::filesystem::path masks = {};
  unsigned threads = 0;  ///< 0: one per core; does not affect the result

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const DenseOptions& options, Visit&& visit) {
  const auto& [pairs, max_image_side, min_agreeing_pairs, tolerance, cell, skip_blurred, masks,
               threads] = options;
  visit("pairs", pairs);
  visit("most_pixels", max_image_side);
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
  FreeSpaceGrid free_space;                          ///< free space in the region
  PhotoRegion region;
  std::vector<StereoPair> pairs;
  std::vector<std::size_t> blurred;  ///< indices of skipped photos
  double cell = 0.0;                 ///< spacing of the points, in units of the model
  std::vector<std::string> notes;
};

/// Computes a dense point cloud by stereo matching of neighbouring photos. A point is kept if
/// several pairs agree on its depth, and if no more pairs see farther along the same line of sight.
/// It is averaged over the agreeing pairs (docs/theory.md).
/// @param model  camera model whose photo files are located
/// @param progress  called with the finished and total number of steps, from one thread at a time
/// @throws InputError  if `stereo_pairs` throws, masks are missing, or the photos do not agree
DenseCloud compute_dense_cloud(const PhotoModel& model, const DenseOptions& options = {},
                               const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace clast
