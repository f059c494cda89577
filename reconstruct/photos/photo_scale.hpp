#pragma once
/// Metres per unit of a model, from markers.
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/scale_board.hpp"

namespace clast {

/// A distance between the centres of two markers.
struct ScaleBar {
  int first = 0, second = 0;  ///< ids
  double length = 0.0;        ///< m
};

template <class Visit>
void visit_fields(const ScaleBar& options, Visit&& visit) {
  const auto& [first, second, length] = options;
  visit("first", first);
  visit("second", second);
  visit("length", length);
}

/// What is known of sizes. Distances between centres come first: they are longer than sides.
struct ScaleOptions {
  std::vector<ScaleBar> bars = {};
  std::optional<ScaleBoard> board = {};
  std::optional<double> marker_side = {};  ///< of the black square of every marker, m
  /// A size that is off by more than this from what the others say is left out, and told.
  double largest_disagreement = 0.005;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScaleOptions& options, Visit&& visit) {
  const auto& [bars, board, marker_side, largest_disagreement] = options;
  visit("bars", bars);
  visit("board", board);
  visit("marker_side", marker_side);
  visit("largest_disagreement", largest_disagreement);
}

/// One size that was compared with the model.
struct ScaleMeasure {
  std::string name;     ///< "marker 2" or "markers 0 and 3" or "row 2 of the board, ..."
  double length = 0.0;  ///< as given, m
  double factor = 0.0;  ///< metres per unit of the model, by this one alone
  double leave_one_out_error =
      0.0;  ///< relative error of its length when the others set the scale; 0 if alone
  bool used = false;
  std::vector<int> markers = {};  ///< ids of those that it is of or between
};

struct PhotoScale {
  double metres_per_unit = 1.0;
  double spread = 0.0;     ///< standard deviation of the factors that were used, relative
  bool from_bars = false;  ///< from distances: bars and those of a board
  std::vector<ScaleMeasure> measures;  ///< distances or sides, whichever set the scale, in order
  /// Where distances set the scale and the side is known too: mean side of the markers by the bars,
  /// relative to what was given.
  std::optional<double> side_check;
  std::vector<int> misplaced;  ///< markers of a board that are not where it has them
  std::vector<std::string> notes;
};

/// The scale: the mean of the factors that agree. Bars and distances on a board go before sides.
/// Where three or more are known, those that differ from the median by too much are left out and
/// named. Of two that disagree neither can be preferred.
/// @param corners  of the ChArUco board, where `options` have one
/// @throws InputError  no distances and no side are given; a bar names a marker that was not found;
///                     sizes contradict each other
PhotoScale estimate_scale_from_markers(const std::vector<LocatedMarker>& markers,
                                       const ScaleOptions& options,
                                       const std::vector<BoardCorner>& corners = {});

}  // namespace clast
