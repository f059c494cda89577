#pragma once
/// Location of printed markers (ArUco, AprilTag) from photos.
#include <array>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

struct MarkerOptions {
  /// Name of the dictionary, such as "4x4_50" or "apriltag_36h11". If "auto", common ones are tried
  /// on some photos. If "none", markers are not searched.
  std::string dictionary = "auto";
  std::size_t min_photos = 3;           ///< minimum number of photos per marker
  double max_reprojection_error = 2.0;  ///< maximum reprojection error of inliers, px
  unsigned threads = 1;  ///< number of threads; 0: one per core; does not affect the result

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const MarkerOptions& options, Visit&& visit) {
  const auto& [dictionary, min_photos, max_reprojection_error, threads] = options;
  visit("dictionary", dictionary);
  visit("fewest_photos", min_photos);
  visit("largest_error", max_reprojection_error);
  visit("threads", ExcludedField{threads});
}

struct LocatedMarker {
  int id = 0;
  std::array<Vec3, 4>
      corners{};           ///< corners, clockwise from the top left, in the frame of the model
  std::size_t photos = 0;  ///< number of photos in which its edges are clear
  double error = 0.0;      ///< root mean square reprojection error of the corners, px

  Vec3 centre() const;
  double side() const;  ///< mean side length, in units of the model
};

/// Marker that could not be located from enough photos.
struct UnlocatedMarker {
  int id = 0;
  std::size_t photos = 0;  ///< number of photos in which its edges are clear
};

struct MarkerSearchResult {
  std::string dictionary;  ///< dictionary that was used; empty if no markers were searched or found
  std::vector<LocatedMarker> markers;      ///< ordered by id
  std::vector<UnlocatedMarker> unlocated;  ///< ordered by id
};

/// Returns the names of all dictionaries, without "auto" and "none".
std::vector<std::string> marker_dictionary_names();

/// Finds markers and triangulates their corners, ordered by id.
///
/// Corners are intersections of lines that are fitted to the edges in undistorted coordinates. Blur
/// does not move straight edges, but it moves corners inwards by about 0.2 px, which shortens sides
/// by 0.2 to 0.8 %. Each corner is triangulated from the pair of photos with which most other
/// photos agree, and refined by least squares over these photos.
/// @param model  camera model whose photo files are located
/// @cite garrido2014
MarkerSearchResult search_markers(const PhotoModel& model, const MarkerOptions& options = {});

}  // namespace clast
