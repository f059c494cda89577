#pragma once
/// Cameras of photos by the program COLMAP, which is not part of clast.
#include <filesystem>
#include <functional>
#include <string>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

struct ColmapOptions {
  std::string program = "colmap";  ///< a path, or a name that is looked up in PATH
  /// Folder that keeps models by the content of their photos; empty: `default_photo_cache`.
  std::filesystem::path cache = {};
  /// Folder of masks, as `find_masks` takes them, or empty. Features are found in what is white.
  std::filesystem::path masks = {};
  double time_limit = 3600.0;         ///< each of its steps may take so long
  int features = 4000;                ///< looked for in each photo
  int most_pixels = 2000;             ///< of the longer side; larger photos are reduced
  std::size_t exhaustive_up_to = 60;  ///< photos; of more, neighbours in order are matched first
  /// Of the photos, must have a camera: with fewer a side of the block is missing.
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

/// clast/photos in the folder for caches of this user (XDG_CACHE_HOME, else ~/.cache), or in that
/// for temporary files.
std::filesystem::path default_photo_cache();

/// Name of a set of photos: a digest of their names and their content.
/// @throws InputError  a file can't be read
std::string compute_photo_digest(const std::filesystem::path& folder);

/// Finds features, matches them, and places the cameras, on the processor alone and without a
/// display; what was found for the same photos before is taken from the cache. COLMAP matches with
/// trees drawn at random, so that two runs of it on the same photos differ a little, in one thread
/// too: what makes a result the same again is the cache.
///
/// The largest group of photos that hang together is returned, with files.
/// @param stage  called with what is being done
/// @throws InputError  what `find_masks` throws; colmap isn't installed (names the package); fewer
///                     than three photos; the photos don't hang together, or only in groups; it
///                     failed or took too long
/// @cite schoenberger2016
PhotoModel run_colmap(const std::filesystem::path& folder, const ColmapOptions& options = {},
                      const std::function<void(const std::string&)>& stage = {});

}  // namespace clast
