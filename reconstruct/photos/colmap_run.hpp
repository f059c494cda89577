#pragma once
/// Camera reconstruction with the external program COLMAP.
#include <filesystem>
#include <functional>
#include <string>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

struct ColmapOptions {
  std::string program = "colmap";  ///< path, or a name looked up in PATH
  /// Cache folder of models, by photo digest; empty: `default_photo_cache`.
  std::filesystem::path cache = {};
  /// Folder of masks (`find_masks`), or empty; features are detected in white areas.
  std::filesystem::path masks = {};
  double time_limit = 3600.0;         ///< time limit of each step, s
  int features = 4000;                ///< maximum number per photo
  int most_pixels = 2000;             ///< of the longer side; larger photos are reduced
  std::size_t exhaustive_up_to = 60;  ///< number of photos up to which all pairs are matched; for
                                      ///< more, neighbours in order first
  /// Minimum fraction of photos with a camera; with fewer, a side of the block is missing.
  double least_share = 0.6;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ColmapOptions& options, Visit&& visit) {
  const auto& [program, cache, masks, time_limit, features, most_pixels, exhaustive_up_to,
               least_share] = options;
  visit("program", program);
  visit("cache", ExcludedField{cache});
  visit("masks", masks);
  visit("seconds", ExcludedField{time_limit});
  visit("features", features);
  visit("most_pixels", most_pixels);
  visit("exhaustive_up_to", exhaustive_up_to);
  visit("least_share", least_share);
}

/// Returns clast/photos in the user's cache folder (XDG_CACHE_HOME or ~/.cache), otherwise in the
/// temporary folder.
std::filesystem::path default_photo_cache();

/// Computes the digest of a set of photos from their names and contents.
/// @throws InputError  if a file cannot be read
std::string compute_photo_digest(const std::filesystem::path& folder);

/// Runs COLMAP on the CPU without display: features, matching and mapping; uses the cache for known
/// photos. COLMAP's matching is randomised even on one thread, so that only the cache makes results
/// reproducible.
///
/// Returns the largest connected group of photos, with files.
/// @param stage  called with the current step
/// @throws InputError  as `find_masks`; if COLMAP is not installed (names the package), there are
///                     fewer than three photos, the photos are not connected, or COLMAP fails or
///                     exceeds its time limit
/// @cite schoenberger2016
PhotoModel run_colmap(const std::filesystem::path& folder, const ColmapOptions& options = {},
                      const std::function<void(const std::string&)>& stage = {});

}  // namespace clast
