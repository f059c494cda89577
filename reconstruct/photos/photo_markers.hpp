#pragma once
/// Printed square markers (ArUco, AprilTag) in photos, and where they are in the model.
#include <array>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

/// How markers are looked for.
struct MarkerOptions {
  /// "4x4_50", "apriltag_36h11", ...; "auto" tries the usual ones on some photos. "none": no
  /// search.
  std::string dictionary = "auto";
  std::size_t fewest_photos = 3;  ///< a marker seen in fewer is left out
  double largest_error = 2.0;     ///< px; a corner farther from where it must be is left out
  unsigned threads = 1;           ///< 0: one per core; the results are the same for any number

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const MarkerOptions& options, Visit&& visit) {
  const auto& [dictionary, fewest_photos, largest_error, threads] = options;
  visit("dictionary", dictionary);
  visit("fewest_photos", fewest_photos);
  visit("largest_error", largest_error);
  visit("threads", ExcludedField{threads});
}

/// A marker that several photos agree on.
struct LocatedMarker {
  int id = 0;
  std::array<Vec3, 4> corners{};  ///< clockwise from the top left, in the frame of the model
  std::size_t photos = 0;         ///< that show it, outliers left out
  double error = 0.0;             ///< root mean square distance of corners in photos, px

  Vec3 centre() const;
  double side() const;  ///< mean of its four, in units of the model
};

/// A marker that too few photos agree on to say where it is.
struct UnlocatedMarker {
  int id = 0;
  std::size_t photos = 0;  ///< that show it with clear edges
};

struct MarkerSearchResult {
  std::string dictionary;            ///< empty: nothing was looked for, or nothing found
  std::vector<LocatedMarker> markers;  ///< in order of ids
  std::vector<UnlocatedMarker> missed;  ///< in order of ids
};

/// Names that `MarkerOptions::dictionary` takes, "auto" and "none" apart.
std::vector<std::string> marker_dictionary_names();

/// Finds markers and triangulates their corners, in order of ids.
///
/// A corner is where the lines through the two edges meet, fitted in the undistorted photo to
/// places of steepest change between black and white; a blurred straight edge stays in its place,
/// where a blurred corner moves inwards (by about 0.2 px, which makes sides 0.2 to 0.8 % short).
/// Each corner is triangulated from the pair of photos that most others agree with, then by least
/// squares over those.
/// @param model  with files
/// @cite garrido2014
MarkerSearchResult search_markers(const PhotoModel& model, const MarkerOptions& options = {});

}  // namespace clast
