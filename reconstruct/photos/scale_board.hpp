#pragma once
/// Scale boards with known distances, and their measurement in photos.
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/number_range.hpp"
#include "reconstruct/photos/charuco_board.hpp"

namespace clast {

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

/// Allowed side length of a marker or board square.
inline constexpr NumberRange kMarkerSide{1e-4, 100.0, "m"};
/// Allowed distance of two markers.
inline constexpr NumberRange kBarLength{1e-4, 1e4, "m"};

/// Board of markers with known centres, or ChArUco board.
struct ScaleBoard {
  std::string dictionary;                  ///< of the markers, as `MarkerOptions::dictionary`
  std::vector<BoardMarker> markers = {};   ///< ids of its markers
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

/// Length known in metres and in model units.
struct KnownLength {
  std::string name;               ///< "markers 0 and 3"
  double metres = 0.0;            ///< as given
  double units = 0.0;             ///< in the model
  std::vector<int> markers = {};  ///< ids of those that it is of or between
};

struct BoardLengths {
  std::vector<KnownLength> lengths;
  std::vector<std::string> notes;  ///< missing and excluded items
  std::vector<int> misplaced;      ///< ids or indices of excluded items
};

/// Measures the distances between all located markers of a board. If board and model differ by more
/// than `largest_disagreement` of the longest distance, the marker whose removal improves the
/// agreement most is excluded, repeatedly, while at least three and more than half remain.
/// @throws InputError  if the rest still disagrees; with three markers the wrong one cannot be
///                     identified
BoardLengths measure_marker_lengths(const ScaleBoard& board,
                                    const std::vector<LocatedMarker>& markers,
                                    double largest_disagreement);

/// Measures the rows and columns of a ChArUco board between the outermost corners found. Corners
/// are excluded like markers.
/// @throws InputError  as above; or if no row or column has two corners
BoardLengths measure_charuco_lengths(const CharucoBoard& board,
                                     const std::vector<BoardCorner>& corners,
                                     double largest_disagreement);

}  // namespace clast
