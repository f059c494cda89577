#pragma once
/// ChArUco boards in photos: printed chessboards with a marker in every white square.
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_markers.hpp"

namespace clast {

/// A board as it was printed. Its corners are those between four squares, row by row: corner k is
/// in column k % (columns - 1) and row k / (columns - 1).
struct CharucoBoard {
  std::string dictionary;     ///< of its markers, as `MarkerOptions::dictionary`; not "auto"
  int columns = 0, rows = 0;  ///< squares, 3 or more each
  double square = 0.0;        ///< side of a square, m
  double marker = 0.0;        ///< side of a marker's black square, m; less than `square`
  /// With an even number of rows OpenCV before 4.6 draws a white square in the first corner and
  /// later versions a black one (opencv issue 23152). True: the older one, as some makers still
  /// print it. Boards with odd rows are the same.
  bool older_pattern = false;

  /// @throws InputError  naming the field and its value; an even number of rows in a pattern that
  ///                     the OpenCV clast was built with doesn't know
  void check() const;
};

template <class Visit>
void visit_fields(const CharucoBoard& options, Visit&& visit) {
  const auto& [dictionary, columns, rows, square, marker, older_pattern] = options;
  visit("dictionary", dictionary);
  visit("columns", columns);
  visit("rows", rows);
  visit("square", square);
  visit("marker", marker);
  visit("older_pattern", older_pattern);
}

/// A corner that several photos agree on.
struct BoardCorner {
  int index = 0;
  Vec3 position = Vec3::Zero();  ///< in the frame of the model
  std::size_t photos = 0;     ///< that show it, outliers left out
  double error = 0.0;         ///< root mean square distance in photos, px
};

/// Finds the corners and triangulates them, in order of their numbers. A corner between black and
/// white squares is a saddle of the grey values, which blur leaves in its place, unlike a corner of
/// a marker.
/// @param model    with files
/// @param options  the dictionary is the board's
std::vector<BoardCorner> find_board_corners(const PhotoModel& model, const CharucoBoard& board,
                                             const MarkerOptions& options = {});

}  // namespace clast
