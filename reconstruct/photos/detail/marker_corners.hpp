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
struct MarkerInPhoto {
  int id = 0;
  std::array<Vec2, 4> corners{};  ///< px
};

/// Names of OpenCV's dictionaries that are tried, the most usual first.
const std::vector<std::string>& dictionary_names();

/// OpenCV's number of a dictionary, and how many markers it has.
/// @throws InputError  no such name
int dictionary_number(const std::string& name);
int dictionary_size(const std::string& name);

/// Markers of a dictionary; corners as OpenCV finds them, to about a pixel. A marker that is found
/// twice is left out.
std::vector<MarkerInPhoto> markers_in(const cv::Mat& grey, const std::string& dictionary);

/// The corners as crossings of lines through the edges, fitted where the lens leaves lines
/// straight. None where an edge is too short, blurred or hidden.
std::optional<MarkerInPhoto> with_edge_corners(const MarkerInPhoto& marker, const cv::Mat& grey,
                                               const Lens& lens);

}  // namespace clast::photos_detail
