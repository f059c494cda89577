#include "shapes/conventional_boxes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shapes/convex_hull.hpp"
#include "shapes/convex_outline.hpp"
#include "shapes/detail/calipers.hpp"

namespace clast {
namespace {

// Distances closer than this share are equally long.
constexpr double kDistanceTie = 1e-11;
// Relative difference below which moments count as equal, as in `principal_frame`.
constexpr double kEqualMoments = 1e-6;
// A shadow shorter than this share of L has no direction of its own.
constexpr double kDot = 1e-12;

/// Pairs of points that are farthest apart, in the order of the points.
template <class Point>
std::vector<std::array<std::size_t, 2>> longest_pairs(const std::vector<Point>& points) {
  double longest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      longest = std::max(longest, (points[i] - points[j]).squaredNorm());
    }
  }
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      // Twice the share: these are squares.
      if ((points[i] - points[j]).squaredNorm() >= (1.0 - 2.0 * kDistanceTie) * longest) {
        pairs.push_back({i, j});
      }
    }
  }
  return pairs;
}

Mat3 frame_about(const Vec3& axis) {
  Mat3 frame;
  frame.col(0) = axis;
  frame.col(1) = axis.unitOrthogonal();
  frame.col(2) = axis.cross(frame.col(1));
  return frame;
}

/// The frame turned about its first axis so that the second is along `direction` of the other two.
Mat3 turned_about_first(const Mat3& frame, const Vec2& direction) {
  Mat3 turned = frame;
  turned.col(1) = (direction.x() * frame.col(1) + direction.y() * frame.col(2)).normalized();
  turned.col(2) = turned.col(0).cross(turned.col(1));
  return turned;
}

/// Corners of the outline of the points' shadow along the first axis of the frame.
std::vector<Vec2> shadow(const std::vector<Vec3>& points, const Mat3& frame) {
  std::vector<Vec2> flat;
  for (const Vec3& p : points) {
    const Vec3 local = p - points.front();
    flat.emplace_back(frame.col(1).dot(local), frame.col(2).dot(local));
  }
  return convex_hull_2d(std::move(flat));
}

/// The smallest box with a side along `axis`.
OrientedBox smallest_box_about(const std::vector<Vec3>& points, const Vec3& axis, double radius) {
  const Mat3 frame = frame_about(axis.normalized());
  const Vec2 direction = smallest_rectangle(shadow(points, frame), radius).direction;
  return box_with_axes(points, turned_about_first(frame, direction), radius);
}

}  // namespace

OrientedBox feret_box(std::span<const Vec3> points, double radius) {
  const std::vector<Vec3> corners = extreme_points(points);
  if (corners.size() < 2) return box_with_axes(corners, Mat3::Identity(), radius);
  OrientedBox best;
  bool first = true;
  for (const auto& [i, j] : longest_pairs(corners)) {
    const double length = (corners[j] - corners[i]).norm();
    const Mat3 frame = frame_about((corners[j] - corners[i]) / length);
    const std::vector<Vec2> outline = shadow(corners, frame);
    for (const auto& [k, l] : longest_pairs(outline)) {
      const Vec2 across = outline[l] - outline[k];
      const Mat3 axes =
          across.norm() > kDot * length ? turned_about_first(frame, across.normalized()) : frame;
      const OrientedBox box = box_with_axes(corners, axes, radius);
      if (first || is_smaller(box, best)) best = box;
      first = false;
    }
    if (first) best = box_with_axes(corners, frame, radius);  // the shadow is a dot
    first = false;
  }
  return best;
}

OrientedBox principal_box(std::span<const Vec3> points, const Mat3& axes, const Vec3& moments,
                          double radius) {
  const std::vector<Vec3> corners = extreme_points(points);
  const double near = kEqualMoments * moments.cwiseAbs().maxCoeff();
  const bool first_two = std::abs(moments[1] - moments[0]) <= near;
  const bool last_two = std::abs(moments[2] - moments[1]) <= near;
  if (first_two && last_two) return smallest_box(corners, radius);
  if (first_two) return smallest_box_about(corners, axes.col(2), radius);
  if (last_two) return smallest_box_about(corners, axes.col(0), radius);
  return box_with_axes(corners, axes, radius);
}

OrientedBox pca_box(std::span<const Vec3> points, double radius) {
  const std::vector<Vec3> corners = extreme_points(points);
  if (corners.empty()) return box_with_axes(corners, Mat3::Identity(), radius);  // refuses
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : corners) mean += p - corners.front();
  mean /= static_cast<double>(corners.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : corners) {
    const Vec3 local = p - corners.front() - mean;
    covariance += local * local.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance);
  return principal_box(corners, eigen.eigenvectors(), eigen.eigenvalues(), radius);
}

}  // namespace clast
