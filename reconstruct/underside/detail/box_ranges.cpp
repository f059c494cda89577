#include "reconstruct/underside/detail/box_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kEverywhere = 1500;    ///< turns spread over all, about 13 degrees apart
constexpr std::size_t kStarts = 32;  ///< of these, those with the smallest boxes are followed down
constexpr double kFirstStep = 0.12, kLastStep = 3e-4;  // rad; halved in between
constexpr double kMinGain = 1e-12;   ///< of a step; less is rounding, which never ends
constexpr double kSameBox = 1e-4;    ///< relative; minima closer than this are one
constexpr std::size_t kMinima = 12;  ///< ... and so many least boxes are looked around
constexpr int kDirections = 24;      ///< a minimum is looked around by turns about so many axes
constexpr int kAngles = 8;           ///< ... by so many angles
constexpr double kMaxAngle = 0.25, kShrink = 0.62;  // rad; each angle against the last
/// Hulls with more corners are simplified; what is lost of an extent is below 1e-3 of it.
constexpr std::size_t kMaxHullCorners = 1500;
constexpr int kLooks = 3000;
/// Boxes larger than the largest by this share count: axes that are looked at are a hair off those
/// of the least boxes, and a body a hair outside of what is possible. No more than so many times
/// what the unseen part adds: without one there is nothing but the least box.
constexpr double kBoxLeeway = 0.003, kLeewayOfAdded = 3.0;
/// Margin for directions between the tested axes, as a fraction of the width of the bounds.
constexpr double kGaps = 0.05;
/// Bounds are rounded outward by this share of a side: what simplified hulls, and edges that run
/// between the points of a scan, lose of it.
constexpr double kRoundedOutward = 5e-4;

/// Points as columns, so that extents along three axes are one product.
Eigen::Matrix3Xd columns(std::span<const Vec3> points) {
  Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    matrix.col(static_cast<Eigen::Index>(i)) = points[i];
  return matrix;
}

/// Evenly spread over the sphere along a spiral.
Vec3 spread_direction(int i, int count) {
  const double z = 1.0 - (2.0 * i + 1.0) / count, around = i * kPi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
}

/// Corners of the hull; of very many those that are outermost along directions spread over all.
std::vector<Vec3> outermost(std::span<const Vec3> points) {
  const std::vector<Vec3> corners = extreme_points(points);
  if (corners.size() <= kMaxHullCorners) return corners;
  std::vector<bool> kept(corners.size(), false);
  const Eigen::Matrix3Xd places = columns(corners);
  for (int i = 0; i < kLooks; ++i) {
    Eigen::Index at = 0;
    (spread_direction(i, kLooks).transpose() * places).maxCoeff(&at);
    kept[static_cast<std::size_t>(at)] = true;
  }
  std::vector<Vec3> found;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (kept[i]) found.push_back(corners[i]);
  }
  return found;
}

Vec3 extents(const Eigen::Matrix3Xd& points, const Mat3& axes) {
  const Eigen::Matrix3Xd along = axes.transpose() * points;
  return along.rowwise().maxCoeff() - along.rowwise().minCoeff();
}

/// Van der Corput's fractions.
double fraction(int i, int base) {
  double value = 0.0, digit = 1.0;
  for (; i > 0; i /= base) value += (digit /= base) * (i % base);
  return value;
}

Mat3 spread_turn(int i) {
  const double u = fraction(i + 1, 2), v = 2.0 * kPi * fraction(i + 1, 3),
               w = 2.0 * kPi * fraction(i + 1, 5);
  return Quat(std::sqrt(u) * std::cos(w), std::sqrt(1.0 - u) * std::sin(v),
              std::sqrt(1.0 - u) * std::cos(v), std::sqrt(u) * std::sin(w))
      .toRotationMatrix();
}

/// Axes with the volume of the box of what was seen along them.
struct BoxOrientation {
  double volume = 0.0;
  Mat3 axes;
};

/// A least box near `orientation`, by steps about its own axes.
BoxOrientation followed_down(const Eigen::Matrix3Xd& points, BoxOrientation orientation) {
  for (double step = kFirstStep; step > kLastStep; step *= 0.5) {
    for (bool moved = true; moved;) {
      moved = false;
      for (int way = 0; way < 6; ++way) {
        const Vec3 axis = (way % 2 == 0 ? 1.0 : -1.0) * orientation.axes.col(way / 2);
        const Mat3 axes = Eigen::AngleAxisd(step, axis) * orientation.axes;
        const double volume = extents(points, axes).prod();
        if (!(volume < (1.0 - kMinGain) * orientation.volume)) continue;
        orientation = {volume, axes};
        moved = true;
      }
    }
  }
  return orientation;
}

bool smaller(const BoxOrientation& a, const BoxOrientation& b) { return a.volume < b.volume; }

/// Places where the box of what was seen is the least of all around, each once.
std::vector<BoxOrientation> least_boxes(const Eigen::Matrix3Xd& points,
                                        std::vector<BoxOrientation> orientations) {
  std::stable_sort(orientations.begin(), orientations.end(), smaller);
  orientations.resize(std::min(orientations.size(), kStarts));
  for (BoxOrientation& orientation : orientations) orientation = followed_down(points, orientation);
  std::stable_sort(orientations.begin(), orientations.end(), smaller);
  const auto same = [](const BoxOrientation& a, const BoxOrientation& b) {
    return b.volume <= (1.0 + kSameBox) * a.volume;
  };
  orientations.erase(std::unique(orientations.begin(), orientations.end(), same),
                     orientations.end());
  orientations.resize(std::min(orientations.size(), kMinima));
  return orientations;
}

}  // namespace

BoxSideBounds bound_box_sides(std::span<const Vec3> observed, std::span<const Vec3> possible) {
  const std::vector<Vec3> inner = outermost(observed), outer = outermost(possible);
  const OrientedBox least = smallest_box(inner), most = smallest_box(outer);
  const Eigen::Matrix3Xd of_inner = columns(inner), of_outer = columns(outer);
  const double added = std::max(0.0, most.volume() / least.volume() - 1.0);
  const double largest = (1.0 + std::min(kBoxLeeway, kLeewayOfAdded * added)) * most.volume();
  BoxSideBounds bounds{least.lengths, least.lengths};
  const auto look = [&](const Mat3& axes) -> BoxOrientation {
    Vec3 low = extents(of_inner, axes);
    const BoxOrientation orientation{low.prod(), axes};
    const double room = largest / orientation.volume;
    if (room < 1.0) return orientation;
    Vec3 high = extents(of_outer, axes).cwiseMin(room * low);
    std::sort(low.begin(), low.end(), std::greater<>());
    std::sort(high.begin(), high.end(), std::greater<>());
    bounds.lower = bounds.lower.cwiseMin(low);
    bounds.upper = bounds.upper.cwiseMax(high);
    return orientation;
  };
  std::vector<BoxOrientation> orientations;
  for (int i = 0; i < kEverywhere; ++i) orientations.push_back(look(spread_turn(i) * least.axes));
  orientations = least_boxes(of_inner, std::move(orientations));
  orientations.push_back({least.volume(), least.axes});
  orientations.push_back({0.0, most.axes});
  for (const BoxOrientation& orientation : orientations) {
    if (orientation.volume > largest) continue;
    look(orientation.axes);
    double angle = kMaxAngle;
    for (int step = 0; step < kAngles; ++step, angle *= kShrink) {
      for (int i = 0; i < kDirections; ++i) {
        look(Eigen::AngleAxisd(angle, spread_direction(i, kDirections)) * orientation.axes);
      }
    }
  }
  const Vec3 gaps = kGaps * (bounds.upper - bounds.lower);
  return {(1.0 - kRoundedOutward) * (bounds.lower - gaps),
          (1.0 + kRoundedOutward) * (bounds.upper + gaps)};
}

}  // namespace clast::reconstruct_detail
