#include "reconstruct/detail/outliers.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "reconstruct/detail/cloud.hpp"

namespace clast::detail {

namespace {

/// The sixth nearest of points scattered at random over a plane lies 1.38/sqrt(density) away.
constexpr int kSixth = 6;
constexpr double kSpacingOfSixth = 0.7236;  // sqrt(pi / 6)
/// Points near a place that its plane goes through.
constexpr std::size_t kNeighbours = 12;
/// Around an outlier the surface shows as points that lie closer together: among so many nearest
/// ones, those whose spacing is so many times smaller than its own.
constexpr int kAround = 40;
constexpr double kIsolated = 1.6;
/// It lies off the planes of the so many nearest of these
constexpr int kWitnesses = 3;
/// by so many of their spacings and standard deviations more, with no point as near as so many of
/// their spacings.
constexpr double kAlone = 1.2;
constexpr double kOffSpacings = 1.5, kOffDeviations = 3.0;
/// Scattered in space, they lie so many times farther apart than most points, and off the plane
/// through them by this share of their spread in it.
constexpr double kStrewn = 8.0, kThick = 0.4;
/// Outliers that lie together hide each other; each round finds those that the one before exposed.
constexpr int kRounds = 10;

/// The plane through points, and how they lie about it: standard deviations across and along, m.
struct PlaneOf {
  Vec3 centre = Vec3::Zero(), normal = Vec3::UnitZ();
  double across = 0.0, along = 0.0;

  double off(const Vec3& point) const { return std::abs(normal.dot(point - centre)); }
};

PlaneOf plane_of(std::span<const Vec3> points) {
  const auto count = static_cast<double>(points.size());
  PlaneOf plane;
  for (const Vec3& p : points) plane.centre += p / count;
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) {
    scatter += (p - plane.centre) * (p - plane.centre).transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
  plane.normal = solver.eigenvectors().col(0);
  plane.across = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  plane.along = std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
  return plane;
}

}  // namespace

std::vector<double> local_spacings(std::span<const Vec3> points) {
  const NearestPoints tree(points);
  std::vector<double> spacings;
  spacings.reserve(points.size());
  for (const Vec3& p : points) {
    spacings.push_back(kSpacingOfSixth * tree.nearest(p, kSixth + 1).back().distance);
  }
  return spacings;
}

namespace {

/// One round over the points.
class Isolation {
 public:
  explicit Isolation(std::span<const Vec3> points)
      : points_(points), tree_(points), spacings_(local_spacings(points)) {
    std::vector<double> sorted = spacings_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    usual_ = *middle;
  }

  bool is_outlier(std::uint32_t point) const {
    const std::vector<NearestPoints::Near> around = tree_.nearest(points_[point], kAround);
    return is_strewn(point, around) || is_off(point, around);
  }

 private:
  PlaneOf plane_without(std::uint32_t left_out, std::span<const NearestPoints::Near> near) const {
    std::vector<Vec3> others;
    for (const NearestPoints::Near& n : near) {
      if (n.point != left_out) others.push_back(points_[n.point]);
    }
    return plane_of(others);
  }

  bool is_strewn(std::uint32_t point, std::span<const NearestPoints::Near> around) const {
    if (spacings_[point] < kStrewn * usual_ || around.size() < kNeighbours) return false;
    const PlaneOf plane = plane_without(point, around.first(kNeighbours));
    return plane.across > kThick * plane.along;
  }

  bool is_off(std::uint32_t point, std::span<const NearestPoints::Near> around) const {
    int witnesses = 0, off = 0;
    for (const NearestPoints::Near& near : around) {
      const double spacing = spacings_[near.point];
      if (!(spacings_[point] > kIsolated * spacing)) continue;
      const PlaneOf plane = plane_without(point, tree_.nearest(points_[near.point], kNeighbours));
      off += around[1].distance > kAlone * spacing &&
             plane.off(points_[point]) > kOffSpacings * spacing + kOffDeviations * plane.across;
      if (++witnesses == kWitnesses) break;
    }
    return off == kWitnesses;
  }

  std::span<const Vec3> points_;
  NearestPoints tree_;
  std::vector<double> spacings_;
  double usual_ = 0.0;  ///< spacing, m
};

}  // namespace

std::vector<std::uint32_t> without_isolated(std::span<const Vec3> points) {
  std::vector<std::uint32_t> kept(points.size());
  std::iota(kept.begin(), kept.end(), 0u);
  for (int round = 0; round < kRounds && kept.size() > kNeighbours; ++round) {
    std::vector<Vec3> left;
    for (const std::uint32_t i : kept) left.push_back(points[i]);
    const Isolation isolation(left);
    std::vector<std::uint32_t> next;
    for (std::uint32_t i = 0; i < left.size(); ++i) {
      if (!isolation.is_outlier(i)) next.push_back(kept[i]);
    }
    if (next.size() == kept.size()) break;
    kept = std::move(next);
  }
  return kept;
}

}  // namespace clast::detail
