#include "reconstruct/photos/charuco_board.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "reconstruct/photos/detail/charuco_corners.hpp"
#include "reconstruct/photos/detail/marker_corners.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"
#include "reconstruct/photos/detail/triangulation.hpp"

namespace clast {

void CharucoBoard::check() const {
  if (columns < 3 || rows < 3 || columns > 100 || rows > 100) {
    throw InputError("ChArUco board: " + std::to_string(columns) + " x " + std::to_string(rows) +
                     " squares; each number must be 3 to 100");
  }
  if (!(square > 0.0 && square < 10.0)) {
    throw InputError("ChArUco board: " + format_significant(square, 6) +
                     " m can't be the side of a square; it must be above 0 and below 10 m");
  }
  if (!(marker > 0.0 && marker < square)) {
    throw InputError("ChArUco board: markers of " + format_significant(marker, 6) +
                     " m don't fit in squares of " + format_significant(square, 6) +
                     " m; check both lengths");
  }
  const int size = photos_detail::dictionary_size(dictionary);
  if (columns * rows / 2 > size) {
    throw InputError("ChArUco board: " + std::to_string(columns) + " x " + std::to_string(rows) +
                     " squares need " + std::to_string(columns * rows / 2) +
                     " markers, but the dictionary " + dictionary + " has " + std::to_string(size));
  }
  if (rows % 2 == 0 && !photos_detail::supports_pattern(older_pattern)) {
    throw InputError(
        "ChArUco board: boards with an even number of rows (" + std::to_string(rows) +
        ") differ between OpenCV before 4.6 and later versions, and clast was built with OpenCV " +
        photos_detail::opencv_version() + ", which supports only the " +
        (older_pattern ? "later" : "older") +
        " ones; use a board with an odd number of rows, or give older_pattern = " +
        (older_pattern ? "false" : "true") + " if this is correct");
  }
}

std::vector<BoardCorner> find_board_corners(const PhotoModel& model, const CharucoBoard& board,
                                            const MarkerOptions& options) {
  options.check();
  board.check();
  const photos_detail::SingleThreadedOpenCv guard;
  std::vector<std::vector<photos_detail::DetectedCorner>> detected(model.photos.size());
  parallel_for(model.photos.size(), options.threads, [&](std::size_t i) {
    const cv::Mat grey = photos_detail::read_grey_photo(model.photos[i].file);
    detected[i] = photos_detail::detect_charuco_corners(grey, board);
    const double to_original =
        static_cast<double>(model.lenses[model.photos[i].lens].width) / grey.cols;
    for (photos_detail::DetectedCorner& corner : detected[i]) {
      corner.pixel = to_original * (corner.pixel + Vec2(0.5, 0.5)) - Vec2(0.5, 0.5);
    }
  });
  std::vector<std::vector<photos_detail::ImageObservation>> observations(
      static_cast<std::size_t>((board.columns - 1) * (board.rows - 1)));
  for (std::size_t i = 0; i < detected.size(); ++i) {
    for (const photos_detail::DetectedCorner& corner : detected[i]) {
      observations[static_cast<std::size_t>(corner.index)].push_back({i, corner.pixel});
    }
  }
  std::vector<BoardCorner> found;
  for (std::size_t index = 0; index < observations.size(); ++index) {
    const auto corner =
        photos_detail::triangulate(model, observations[index], options.max_reprojection_error);
    if (!corner || corner->inlier_count < options.min_photos) continue;
    found.push_back({static_cast<int>(index), corner->position, corner->inlier_count,
                     std::sqrt(corner->squared_error / static_cast<double>(corner->inlier_count))});
  }
  return found;
}

}  // namespace clast
