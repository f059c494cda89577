#include "reconstruct/detail/box_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"

namespace clast::detail {

namespace {

constexpr int kEverywhere = 1500;    ///< turns spread over all, about 13 degrees apart
constexpr std::size_t kNarrow = 16;  ///< of these, those with the smallest boxes are looked around
constexpr int kDirections = 40;      ///< ... by turns about so many axes
constexpr int kAngles = 10;          ///< ... by so many angles
constexpr double kLargestAngle = 0.25, kShrink = 0.62;  // rad; each angle against the last

/// Points as columns, so that extents along three axes are one product.
Eigen::Matrix3Xd columns(std::span<const Vec3> points) {
  Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    matrix.col(static_cast<Eigen::Index>(i)) = points[i];
  return matrix;
}

Vec3 extents(const Eigen::Matrix3Xd& points, const Mat3& axes) {
  const Eigen::Matrix3Xd along = axes.transpose() * points;
  return along.rowwise().maxCoeff() - along.rowwise().minCoeff();
}

/// Evenly spread over the sphere along a spiral.
Vec3 spread_direction(int i, int count) {
  const double z = 1.0 - (2.0 * i + 1.0) / count, around = i * kPi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
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

}  // namespace

SideBounds box_ranges(std::span<const Vec3> seen, std::span<const Vec3> possible, double margin) {
  const std::vector<Vec3> inner = extreme_points(seen), outer = extreme_points(possible);
  const OrientedBox least = smallest_box(inner), most = smallest_box(outer);
  const Eigen::Matrix3Xd of_inner = columns(inner), of_outer = columns(outer);
  const double largest = (most.lengths.array() + 2.0 * margin).prod();
  SideBounds bounds{least.lengths, least.lengths};
  const auto look = [&](const Mat3& axes) {
    Vec3 low = extents(of_inner, axes);
    const double volume = low.prod(), room = largest / volume;
    if (room < 1.0) return volume;
    Vec3 high = (extents(of_outer, axes).array() + 2.0 * margin).matrix().cwiseMin(room * low);
    std::sort(low.begin(), low.end(), std::greater<>());
    std::sort(high.begin(), high.end(), std::greater<>());
    bounds.lower = bounds.lower.cwiseMin(low);
    bounds.upper = bounds.upper.cwiseMax(high);
    return volume;
  };
  struct Turn {
    double volume;
    Mat3 axes;
  };
  std::vector<Turn> turns;
  for (int i = 0; i < kEverywhere; ++i) {
    const Mat3 axes = spread_turn(i) * least.axes;
    turns.push_back({look(axes), axes});
  }
  std::stable_sort(turns.begin(), turns.end(),
                   [](const Turn& a, const Turn& b) { return a.volume < b.volume; });
  turns.resize(kNarrow);
  turns.push_back({least.volume(), least.axes});
  turns.push_back({most.volume(), most.axes});
  for (const Turn& turn : turns) {
    look(turn.axes);
    double angle = kLargestAngle;
    for (int step = 0; step < kAngles; ++step, angle *= kShrink) {
      for (int i = 0; i < kDirections; ++i) {
        look(Eigen::AngleAxisd(angle, spread_direction(i, kDirections)) * turn.axes);
      }
    }
  }
  return bounds;
}

}  // namespace clast::detail
