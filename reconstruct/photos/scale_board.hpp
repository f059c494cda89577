#pragma once
/// Scale boards with known distances, and their measurement in a camera model.
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/number_range.hpp"
#include "reconstruct/photos/charuco_board.hpp"

namespace clast {

struct BoardMarker {
  int id = 0;
  Vec3 centre = Vec3::Zero();  ///< position in any frame, m
};

template <class Visit>
void visit_fields(const BoardMarker& options, Visit&& visit) {
  const auto& [id, centre] = options;
  visit("id", id);
  visit("centre", centre);
}

/// Allowed side length of a marker or board square.
inline constexpr NumberRange kMarkerSideRange{1e-4, 100.0, "m"};
/// Allowed distance of two markers.
inline constexpr NumberRange kBarLengthRange{1e-4, 1e4, "m"};

/// Board of markers with known centres, or ChArUco board.
struct ScaleBoard {
  std::string dictionary;  ///< dictionary of the markers (`MarkerOptions::dictionary`)
  std::vector<BoardMarker> markers = {};   ///< markers of the board; empty for a ChArUco board
  std::optional<double> marker_side = {};  ///< side length of the markers, m
  std::optional<CharucoBoard> charuco = {};

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScaleBoard& options, Visit&& visit) {
  const auto& [dictionary, markers, marker_side, charuco] = options;
  visit("dictionary", dictionary);
  visit("markers", markers);
  visit("marker_side", marker_side);
  visit("charuco", charuco);
}

/// Length known in metres and in model units.
struct KnownLength {
  std::string name;               ///< such as "markers 0 and 3"
  double metres = 0.0;            ///< length as given, m
  double units = 0.0;             ///< length in the model, in model units
  std::vector<int> markers = {};  ///< ids of the markers that define it
};

/// Distances measured on a scale board, with excluded markers or corners.
struct BoardLengths {
  std::vector<KnownLength> lengths;
  std::vector<std::string> notes;  ///< notes on missing and excluded markers or corners
  std::vector<int> misplaced;      ///< ids of excluded markers, or indices of excluded corners
};

/// Measures the distances between all located markers of a board. While board and model differ by
/// more than `max_disagreement` of the longest distance, the marker whose removal improves the
/// agreement most is excluded. At least three markers, and more than half, must remain.
/// @throws InputError  if the remaining markers still disagree; among three, the wrong one cannot
///                     be identified
BoardLengths measure_marker_distances(const ScaleBoard& board,
                                      const std::vector<LocatedMarker>& markers,
                                      double max_disagreement);

/// Measures the rows and columns of a ChArUco board. Each length is that between the outermost
/// corners that were found. Corners are excluded in the same way as markers.
/// @throws InputError  if the remaining corners disagree, or no row or column has two corners
BoardLengths measure_charuco_lengths(const CharucoBoard& board,
                                     const std::vector<BoardCorner>& corners,
                                     double max_disagreement);

}  // namespace clast
