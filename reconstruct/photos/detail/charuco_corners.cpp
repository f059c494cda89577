#include "reconstruct/photos/detail/charuco_corners.hpp"

#include <opencv2/core/version.hpp>

#include "reconstruct/photos/detail/marker_corners.hpp"

#define CLAST_OPENCV (CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR)
#if CLAST_OPENCV >= 407
#include <opencv2/objdetect/charuco_detector.hpp>
#else
#include <opencv2/aruco/charuco.hpp>
#endif

namespace clast::photos_detail {

namespace {

struct Found {
  std::vector<cv::Point2f> corners;
  std::vector<int> numbers;
};

Found found_in(const cv::Mat& grey, const CharucoBoard& board) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(opencv_dictionary(board.dictionary));
  const auto square = static_cast<float>(board.square), marker = static_cast<float>(board.marker);
  Found found;
#if CLAST_OPENCV >= 407
  cv::aruco::CharucoBoard printed(cv::Size(board.columns, board.rows), square, marker, dictionary);
#if CLAST_OPENCV >= 408
  printed.setLegacyPattern(board.older_pattern);
#endif
  const cv::aruco::CharucoDetector detector(printed);
  detector.detectBoard(grey, found.corners, found.numbers);
#else
  const auto printed =
      cv::aruco::CharucoBoard::create(board.columns, board.rows, square, marker, dictionary);
  std::vector<std::vector<cv::Point2f> > quads;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, dictionary, quads, ids);
  if (ids.empty()) return found;
  cv::aruco::interpolateCornersCharuco(quads, ids, grey, printed, found.corners, found.numbers);
#endif
  return found;
}

}  // namespace

std::vector<DetectedCorner> detect_charuco_corners(const cv::Mat& grey, const CharucoBoard& board) {
  const Found found = found_in(grey, board);
  std::vector<DetectedCorner> corners;
  for (std::size_t i = 0; i < found.numbers.size(); ++i) {
    corners.push_back({found.numbers[i], {found.corners[i].x, found.corners[i].y}});
  }
  return corners;
}

bool supports_pattern([[maybe_unused]] bool older) {
#if CLAST_OPENCV >= 408
  return true;
#elif CLAST_OPENCV >= 406
  return !older;
#else
  return older;
#endif
}

std::string opencv_version() { return CV_VERSION; }

}  // namespace clast::photos_detail
