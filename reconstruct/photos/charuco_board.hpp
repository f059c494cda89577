#pragma once
/// ChArUco boards in photos: printed chessboards with markers in the white squares.
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/photo_markers.hpp"

namespace clast {

/// ChArUco board. Its corners are those between four squares, row-major: corner k is in column k %
/// (columns - 1) and row k / (columns - 1).
struct CharucoBoard {
  std::string dictionary;     ///< of its markers, as `MarkerOptions::dictionary`; not "auto"
  int columns = 0, rows = 0;  ///< number of squares, at least 3 each
  double square = 0.0;        ///< side length of a square, m
  double marker = 0.0;        ///< side length of a marker's black square, m; less than `square`
  /// Pattern of boards with an even number of rows: the first corner has a white square before
  /// OpenCV 4.6 (true) and a black one later (opencv issue 23152).
  bool older_pattern = false;

  /// Checks the board.
  /// @throws InputError  naming field and value; also if the pattern is not supported by the OpenCV
  ///                     in use
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
  std::size_t photos = 0;        ///< number of inlier photos
  double error = 0.0;            ///< root mean square reprojection error, px
};

/// Finds and triangulates the corners, in index order. Chessboard corners are saddle points, whose
/// position is not biased by blur, unlike marker corners.
/// @param model  with files
/// @param options  with the board's dictionary
std::vector<BoardCorner> find_board_corners(const PhotoModel& model, const CharucoBoard& board,
                                            const MarkerOptions& options = {});

}  // namespace clast
