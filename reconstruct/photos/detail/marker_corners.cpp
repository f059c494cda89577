#include "reconstruct/photos/detail/marker_corners.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core/version.hpp>

#include "core/error.hpp"

#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace clast::photos_detail {

namespace {

constexpr double kMinSide = 16.0;      ///< px; cells of less than 3 px have no edges of their own
constexpr double kFromCorner = 0.12;   ///< of the side: the edge there is bent by the blur
constexpr double kReach = 3.0;         ///< px to each side of an edge
constexpr double kProfileStep = 0.25;  ///< px
constexpr double kMinContrast = 20.0;  ///< grey levels
constexpr double kFurthestFit = 0.8;   ///< px off the line; such places are left out
constexpr std::size_t kMinPlaces = 6;

struct KnownDictionary {
  std::string name;
  int value;
};

const std::vector<KnownDictionary>& dictionaries() {
  static const std::vector<KnownDictionary> kKnown = {
      {"4x4_50", cv::aruco::DICT_4X4_50},
      {"apriltag_36h11", cv::aruco::DICT_APRILTAG_36h11},
      {"6x6_250", cv::aruco::DICT_6X6_250},
      {"5x5_100", cv::aruco::DICT_5X5_100},
      {"4x4_250", cv::aruco::DICT_4X4_250},
      {"5x5_250", cv::aruco::DICT_5X5_250},
      {"7x7_250", cv::aruco::DICT_7X7_250},
      {"aruco_original", cv::aruco::DICT_ARUCO_ORIGINAL},
      {"apriltag_25h9", cv::aruco::DICT_APRILTAG_25h9},
      {"apriltag_16h5", cv::aruco::DICT_APRILTAG_16h5}};
  return kKnown;
}

/// Grey value between pixels.
double grey_at(const cv::Mat& grey, const Vec2& p) {
  const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
  if (x < 0 || y < 0 || x + 1 >= grey.cols || y + 1 >= grey.rows) return -1.0;
  const double u = p.x() - x, v = p.y() - y;
  return (1.0 - v) *
             ((1.0 - u) * grey.at<unsigned char>(y, x) + u * grey.at<unsigned char>(y, x + 1)) +
         v * ((1.0 - u) * grey.at<unsigned char>(y + 1, x) +
              u * grey.at<unsigned char>(y + 1, x + 1));
}

/// Finds the edge from black inside to white outside along `outward` through `middle`: the centroid
/// of the rise. Empty if there is no clear edge.
std::optional<Vec2> edge_at(const cv::Mat& grey, const Vec2& middle, const Vec2& outward,
                            double reach) {
  double weight = 0.0, moment = 0.0, lowest = 256.0, highest = -1.0;
  double before = grey_at(grey, middle - reach * outward);
  for (double s = -reach + kProfileStep; s <= reach + 1e-9; s += kProfileStep) {
    const double now = grey_at(grey, middle + s * outward);
    if (now < 0.0 || before < 0.0) return std::nullopt;
    const double rise = now - before;
    weight += rise;
    moment += rise * (s - 0.5 * kProfileStep);
    lowest = std::min(lowest, now);
    highest = std::max(highest, now);
    before = now;
  }
  if (weight < kMinContrast || weight < 0.6 * (highest - lowest)) return std::nullopt;
  const double position = moment / weight;
  if (std::abs(position) > reach) return std::nullopt;
  return Vec2(middle + position * outward);
}

/// A line n . p = d through places, in a plane where the lens leaves lines straight.
struct Line {
  Vec2 normal;
  double distance;
};

Line fitted(const std::vector<Vec2>& places) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : places) mean += p / static_cast<double>(places.size());
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Vec2& p : places) {
    const Vec2 d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy) + 0.5 * kPi;
  const Vec2 normal(std::cos(angle), std::sin(angle));
  return {normal, normal.dot(mean)};
}

std::optional<Line> edge_line(const cv::Mat& grey, const CameraIntrinsics& lens, const Vec2& from,
                              const Vec2& to, const Vec2& inside) {
  const Vec2 along = to - from;
  const double length = along.norm();
  if (length < kMinSide) return std::nullopt;
  Vec2 outward(along.y() / length, -along.x() / length);
  if (outward.dot(inside - from) > 0.0) outward = -outward;
  // The black border is a sixth of the side, or an eighth.
  const double reach = std::min(kReach, length / 10.0);
  std::vector<Vec2> places;  // in the plane at depth 1
  const int count = std::max(10, static_cast<int>(length / 2.0));
  for (int i = 0; i < count; ++i) {
    const double fraction = kFromCorner + (1.0 - 2.0 * kFromCorner) * (i + 0.5) / count;
    const Vec2 middle = from + fraction * along;
    std::optional<Vec2> position = edge_at(grey, middle, outward, reach);
    // Once more about the edge itself, so that the profile lies evenly to both sides.
    if (position) position = edge_at(grey, *position, outward, reach);
    const std::optional<Vec3> direction =
        position ? unproject(lens, *position) : std::optional<Vec3>();
    if (direction) places.push_back(direction->head<2>());
  }
  for (int pass = 0; pass < 3; ++pass) {
    if (places.size() < std::max<std::size_t>(kMinPlaces, static_cast<std::size_t>(count) / 2)) {
      return std::nullopt;
    }
    const Line line = fitted(places);
    const double most = kFurthestFit / lens.fx / (1.0 + pass);
    std::erase_if(
        places, [&](const Vec2& p) { return std::abs(line.normal.dot(p) - line.distance) > most; });
  }
  return places.size() < kMinPlaces ? std::nullopt : std::optional(fitted(places));
}

std::optional<Vec2> crossing(const Line& a, const Line& b) {
  const double det = cross(a.normal, b.normal);
  if (std::abs(det) < 0.05) return std::nullopt;
  return Vec2((a.distance * b.normal.y() - b.distance * a.normal.y()) / det,
              (b.distance * a.normal.x() - a.distance * b.normal.x()) / det);
}

}  // namespace

const std::vector<std::string>& common_dictionary_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const KnownDictionary& known : dictionaries()) names.push_back(known.name);
    return names;
  }();
  return kNames;
}

int opencv_dictionary(const std::string& name) {
  std::string names;
  for (const KnownDictionary& known : dictionaries()) {
    if (known.name == name) return known.value;
    names += " " + known.name;
  }
  throw InputError("marker dictionary \"" + name + "\" isn't known; known are" + names);
}

int dictionary_size(const std::string& name) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(opencv_dictionary(name));
#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407
  return dictionary.bytesList.rows;
#else
  return dictionary->bytesList.rows;
#endif
}

std::vector<DetectedMarker> detect_markers(const cv::Mat& grey, const std::string& dictionary) {
  std::vector<std::vector<cv::Point2f>> quads;
  std::vector<int> ids;
#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407
  const cv::aruco::ArucoDetector detector(
      cv::aruco::getPredefinedDictionary(opencv_dictionary(dictionary)));
  detector.detectMarkers(grey, quads, ids);
#else
  const auto parameters = cv::aruco::DetectorParameters::create();
  cv::aruco::detectMarkers(grey, cv::aruco::getPredefinedDictionary(opencv_dictionary(dictionary)),
                           quads, ids, parameters);
#endif
  std::map<int, int> times;
  for (const int id : ids) ++times[id];
  std::vector<DetectedMarker> found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (times[ids[i]] > 1) continue;
    DetectedMarker marker{ids[i], {}};
    for (std::size_t k = 0; k < 4; ++k) marker.corners[k] = {quads[i][k].x, quads[i][k].y};
    found.push_back(marker);
  }
  std::sort(found.begin(), found.end(),
            [](const DetectedMarker& a, const DetectedMarker& b) { return a.id < b.id; });
  return found;
}

std::optional<DetectedMarker> refine_marker_corners(const DetectedMarker& marker,
                                                    const cv::Mat& grey,
                                                    const CameraIntrinsics& lens) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : marker.corners) middle += 0.25 * corner;
  std::array<Line, 4> lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::optional<Line> line =
        edge_line(grey, lens, marker.corners[k], marker.corners[(k + 1) % 4], middle);
    if (!line) return std::nullopt;
    lines[k] = *line;
  }
  DetectedMarker result = marker;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::optional<Vec2> position = crossing(lines[(k + 3) % 4], lines[k]);
    if (!position) return std::nullopt;
    const std::optional<Vec2> pixel = project(lens, {position->x(), position->y(), 1.0});
    if (!pixel || (*pixel - marker.corners[k]).norm() > 2.0 * kReach) return std::nullopt;
    result.corners[k] = *pixel;
  }
  return result;
}

}  // namespace clast::photos_detail
