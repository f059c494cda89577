#pragma once
/// Markers in one photo, by OpenCV.
#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/photos/lens.hpp"

namespace clast::photos_detail {

/// A marker as one photo shows it.
struct DetectedMarker {
  int id = 0;
  std::array<Vec2, 4> corners{};  ///< px
};

/// Names of OpenCV's dictionaries that are tried, the most usual first.
const std::vector<std::string>& common_dictionary_names();

/// OpenCV's number of a dictionary, and how many markers it has.
/// @throws InputError  no such name
int opencv_dictionary(const std::string& name);
int dictionary_size(const std::string& name);

/// Markers of a dictionary; corners as OpenCV finds them, to about a pixel. A marker that is found
/// twice is left out.
std::vector<DetectedMarker> detect_markers(const cv::Mat& grey, const std::string& dictionary);

/// The corners as crossings of lines through the edges, fitted where the lens leaves lines
/// straight. None where an edge is too short, blurred or hidden.
std::optional<DetectedMarker> refine_marker_corners(const DetectedMarker& marker, const cv::Mat& grey,
                                               const CameraIntrinsics& lens);

}  // namespace clast::photos_detail
