#pragma once
/// Boards: things of which all distances are known, and what photos show of them.
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/number_range.hpp"
#include "reconstruct/photos/charuco_board.hpp"

namespace clast {

/// A marker on a board.
struct BoardMarker {
  int id = 0;
  Vec3 centre = Vec3::Zero();  ///< m, in any frame
};

template <class Visit>
void visit_fields(const BoardMarker& options, Visit&& visit) {
  const auto& [id, centre] = options;
  visit("id", id);
  visit("centre", centre);
}

/// The side of a printed marker or of a square of a board.
inline constexpr NumberRange kMarkerSide{1e-4, 100.0, "m"};
/// The distance of two markers.
inline constexpr NumberRange kBarLength{1e-4, 1e4, "m"};

/// Markers whose centres were measured or printed, or a ChArUco board.
struct ScaleBoard {
  std::string dictionary;                  ///< of the markers, as `MarkerOptions::dictionary`
  std::vector<BoardMarker> markers = {};   ///< two or more, or none with `charuco`
  std::optional<double> marker_side = {};  ///< m
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

/// A length that is known in metres and in the model.
struct KnownLength {
  std::string name;               ///< "markers 0 and 3"
  double metres = 0.0;            ///< as given
  double units = 0.0;             ///< of the model
  std::vector<int> markers = {};  ///< ids of those that it is of or between
};

struct BoardLengths {
  std::vector<KnownLength> lengths;
  std::vector<std::string> notes;  ///< what was not found, and what disagrees and is left out
  std::vector<int> misplaced;      ///< ids or numbers of what disagrees
};

/// The distances between all markers of the board that were found. Where the board and the model
/// are not alike to `largest_disagreement` of the longest distance, the marker without which the
/// rest is most alike is left out and named, and again, as long as three and more than half remain.
/// @throws InputError  the rest is not alike either: with three markers nobody can tell which is
///                     wrong
BoardLengths measure_marker_lengths(const ScaleBoard& board, const std::vector<LocatedMarker>& markers,
                                double largest_disagreement);

/// The lengths of the rows and columns of a ChArUco board, from the first to the last corner found
/// in each. Corners that disagree are left out as markers are.
/// @throws InputError  as above; no two corners in a row or a column
BoardLengths measure_charuco_lengths(const CharucoBoard& board, const std::vector<BoardCorner>& corners,
                                double largest_disagreement);

}  // namespace clast
