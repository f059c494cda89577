#pragma once
/// Camera reconstruction with the external program COLMAP.
#include <filesystem>
#include <functional>
#include <string>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

struct ColmapOptions {
  std::string program = "colmap";  ///< path of the program, or its name in PATH
  /// Cache folder of models by photo digest. If empty, `default_photo_cache` is used.
  std::filesystem::path cache = {};
  /// Folder of masks (`find_masks`), or empty. Features are only detected in white areas.
  std::filesystem::path masks = {};
  double time_limit = 3600.0;  ///< time limit of each step, s
  int features = 4000;         ///< maximum number of features per photo
  int max_image_side =
      2000;  ///< maximum length of the longer side, px; larger photos are scaled down
  std::size_t max_exhaustive_photos =
      60;  ///< maximum number of photos for which all pairs are matched;
           ///< otherwise, neighbours in order are matched first
  /// Minimum fraction of photos with a camera. Otherwise, a side of the block is missing.
  double min_posed_fraction = 0.6;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ColmapOptions& options, Visit&& visit) {
  const auto& [program, cache, masks, time_limit, features, max_image_side, max_exhaustive_photos,
               min_posed_fraction] = options;
  visit("program", program);
  visit("cache", ExcludedField{cache});
  visit("masks", masks);
  visit("seconds", ExcludedField{time_limit});
  visit("features", features);
  visit("most_pixels", max_image_side);
  visit("exhaustive_up_to", max_exhaustive_photos);
  visit("least_share", min_posed_fraction);
}

/// Returns the folder clast/photos in the user's cache folder (XDG_CACHE_HOME or ~/.cache). Without
/// a cache folder, it is in the temporary folder.
std::filesystem::path default_photo_cache();

/// Computes the digest of a set of photos from their names and contents.
/// @throws InputError  if a file cannot be read
std::string compute_photo_digest(const std::filesystem::path& folder);

/// Runs COLMAP on the CPU without display: feature detection, matching and mapping. If the cache
/// contains the photos, its model is used. COLMAP's matching is random even on one thread, so only
/// the cache makes results reproducible.
///
/// Returns the largest connected group of photos, with their files.
/// @param stage  called with the current step
/// @throws InputError  if `find_masks` throws, COLMAP is not installed, there are fewer than three
///                     photos, they are not connected, or COLMAP fails or exceeds its limit
/// @cite schoenberger2016
PhotoModel run_colmap(const std::filesystem::path& folder, const ColmapOptions& options = {},
                      const std::function<void(const std::string&)>& stage = {});

}  // namespace clast
