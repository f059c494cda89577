#pragma once
/// Detection of markers in a photo with OpenCV.
#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/photos/lens.hpp"

namespace clast::photos_detail {

struct DetectedMarker {
  int id = 0;
  std::array<Vec2, 4> corners{};  ///< px
};

/// Returns the names of common OpenCV dictionaries, the most usual first.
const std::vector<std::string>& common_dictionary_names();

/// Returns the index of a dictionary in OpenCV. `dictionary_size` returns its number of markers.
/// @throws InputError  if the name is unknown
int opencv_dictionary(const std::string& name);
int dictionary_size(const std::string& name);

/// Detects markers. Corners are accurate to about a pixel. Duplicate markers are skipped.
std::vector<DetectedMarker> detect_markers(const cv::Mat& grey, const std::string& dictionary);

/// Refines the corners as intersections of lines that are fitted to the edges in undistorted
/// coordinates. Empty if an edge is too short, blurred or hidden.
std::optional<DetectedMarker> refine_marker_corners(const DetectedMarker& marker,
                                                    const cv::Mat& grey,
                                                    const CameraIntrinsics& lens);

}  // namespace clast::photos_detail
