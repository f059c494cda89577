#pragma once
/// Estimation of the scale of a camera model from markers.
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/scale_board.hpp"

namespace clast {

/// Known distance between the centres of two markers.
struct ScaleBar {
  int first = 0, second = 0;  ///< marker ids
  double length = 0.0;        ///< as given, m
};

template <class Visit>
void visit_fields(const ScaleBar& options, Visit&& visit) {
  const auto& [first, second, length] = options;
  visit("first", first);
  visit("second", second);
  visit("length", length);
}

/// Known lengths from which the scale is estimated. Marker distances have priority over marker
/// sides, because they are longer.
struct ScaleOptions {
  std::vector<ScaleBar> bars = {};
  std::optional<ScaleBoard> board = {};
  std::optional<double> marker_side = {};  ///< side length of the black square of all markers, m
  /// Maximum relative deviation of a length from the others. Larger ones are excluded and reported.
  double max_disagreement = 0.005;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScaleOptions& options, Visit&& visit) {
  const auto& [bars, board, marker_side, max_disagreement] = options;
  visit("bars", bars);
  visit("board", board);
  visit("marker_side", marker_side);
  visit("largest_disagreement", max_disagreement);
}

/// Known length compared with its length in the model.
struct ComparedLength {
  std::string name;     ///< such as "marker 2", "markers 0 and 3" or "row 2 of the board, ..."
  double length = 0.0;  ///< as given, m
  double factor = 0.0;  ///< scale from this length alone, m per model unit
  double leave_one_out_error = 0.0;  ///< relative error of its length if the scale is estimated
                                     ///< from the others; 0 if there are no others
  bool used = false;
  std::vector<int> markers = {};  ///< ids of the markers that define it
};

struct PhotoScale {
  double metres_per_unit = 1.0;
  double spread = 0.0;                   ///< relative standard deviation of the used factors
  bool from_bars = false;                ///< true if estimated from distances (bars or a board)
  std::vector<ComparedLength> measures;  ///< lengths that determined the scale: distances or sides
  /// Mean marker side, scaled by the distances, relative to the given side. Set if both are known.
  std::optional<double> marker_side_ratio;
  std::vector<int> misplaced;  ///< ids of board markers that are not at the stated positions
  std::vector<std::string> notes;
};

/// Estimates the scale of a camera model as the mean of the factors of consistent lengths. Bars and
/// board distances have priority over marker sides. If there are three or more lengths, those whose
/// factor deviates too much from the median are excluded and reported.
/// @param corners  corners of the ChArUco board, if there is one
/// @throws InputError  if no distance or side is given, a bar names a marker that was not found, or
///                     lengths contradict each other
PhotoScale estimate_scale_from_markers(const std::vector<LocatedMarker>& markers,
                                       const ScaleOptions& options,
                                       const std::vector<BoardCorner>& corners = {});

}  // namespace clast
