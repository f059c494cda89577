#pragma once
/// Location of ChArUco boards (printed chessboards with markers in the white squares) from photos.
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_markers.hpp"

namespace clast {

/// ChArUco board. Its corners are the points at which four squares meet. They are numbered row by
/// row: corner k is in column k % (columns - 1) and row k / (columns - 1).
struct CharucoBoard {
  std::string dictionary;  ///< dictionary of its markers (`MarkerOptions::dictionary`), not "auto"
  int columns = 0, rows = 0;  ///< number of squares, at least 3 each
  double square = 0.0;        ///< side length of a square, m
  double marker = 0.0;  ///< side length of the black square of a marker, m; less than `square`
  /// True if a board with an even number of rows has a white square in its first corner, as drawn
  /// by OpenCV before version 4.6. Later versions draw a black one (opencv issue 23152).
  bool older_pattern = false;

  /// Checks the dimensions and pattern of the board.
  /// @throws InputError  if a value is out of range, or the OpenCV in use does not support the
  ///                     pattern; names field and value
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

/// Board corner located from several photos.
struct BoardCorner {
  int index = 0;
  Vec3 position = Vec3::Zero();  ///< in the frame of the model
  std::size_t photos = 0;        ///< number of photos that agree on its position
  double error = 0.0;            ///< root mean square reprojection error, px
};

/// Finds and triangulates the corners, ordered by index. Unlike the corners of markers, those of a
/// chessboard are saddle points, whose position is not biased by blur.
/// @param model  camera model whose photo files are located
/// @param options  marker options with the dictionary of the board
std::vector<BoardCorner> find_board_corners(const PhotoModel& model, const CharucoBoard& board,
                                            const MarkerOptions& options = {});

}  // namespace clast
