#pragma once
/// Corners of a ChArUco board in one photo, by OpenCV.
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "reconstruct/photos/charuco_board.hpp"

namespace clast::photos_detail {

/// A corner as one photo shows it.
struct DetectedCorner {
  int index = 0;
  Vec2 pixel = Vec2::Zero();  ///< px
};

/// Corners beside two markers that were found, refined to the saddles of the grey values.
/// @param board  checked
std::vector<DetectedCorner> detect_charuco_corners(const cv::Mat& grey, const CharucoBoard& board);

/// Does this OpenCV know boards of the older or of the later pattern, where they differ?
bool supports_pattern(bool older);

/// "4.6.0"
std::string opencv_version();

}  // namespace clast::photos_detail
