#pragma once
/// Detection of ChArUco corners in a photo with OpenCV.
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "reconstruct/photos/charuco_board.hpp"

namespace clast::photos_detail {

struct DetectedCorner {
  int index = 0;
  Vec2 pixel = Vec2::Zero();  ///< px
};

/// Detects corners next to two detected markers, and refines them to saddle points of the image.
/// @param board  board that passes `CharucoBoard::check`
std::vector<DetectedCorner> detect_charuco_corners(const cv::Mat& grey, const CharucoBoard& board);

/// True if the OpenCV in use supports the older (or later) pattern of boards.
bool supports_pattern(bool older);

/// Returns the OpenCV version, such as "4.6.0".
std::string opencv_version();

}  // namespace clast::photos_detail
