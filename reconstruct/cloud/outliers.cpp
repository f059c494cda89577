#include "reconstruct/cloud/outliers.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/statistics/statistics.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

namespace {

/// The sixth nearest of points strewn at random over a plane lies 1.38/sqrt(density) away.
constexpr int kSixth = 6;
constexpr double kSpacingOfSixth = 0.7236;  // sqrt(pi / 6)
/// Points near a place that its plane goes through.
constexpr std::size_t kPlaneNeighbours = 12;
/// Around an outlier the surface shows as points that lie closer together: among so many nearest
/// ones, those whose spacing is so many times smaller than its own.
constexpr int kAround = 40;
constexpr int kSuspectNeighbours = 8;  ///< among which one shows that a point needs a closer look
constexpr double kIsolated = 1.6;
/// It lies off the planes of the so many nearest of these
constexpr int kWitnesses = 3;
/// An outlier has no point within this many of their spacings, and its distance from their planes
/// exceeds this many spacings plus standard deviations.
constexpr double kAlone = 1.2;
constexpr double kOutlierSpacings = 1.5, kOutlierDeviations = 3.0;
/// Scattered through space, they lie so many times farther apart than most points, and off the
/// plane through them by this share of their spread in it.
constexpr double kScattered = 8.0, kThick = 0.4;
/// Outliers that lie together hide each other; the next round finds what the one before bared.
constexpr int kOutlierRounds = 10;

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

std::vector<std::uint32_t> find_first_duplicates(std::span<const Vec3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = points[a], &q = points[b];
    return p == q ? a < b : std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  std::sort(order.begin(), order.end(), less);
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::vector<double> compute_local_spacings(std::span<const Vec3> points) {
  const PointTree tree(points);
  std::vector<double> spacings;
  spacings.reserve(points.size());
  for (const Vec3& p : points) {
    spacings.push_back(kSpacingOfSixth * tree.nearest_neighbours(p, kSixth + 1).back().distance);
  }
  return spacings;
}

namespace {

/// The points that are left, and how far apart they lie.
class Isolation {
 public:
  Isolation(std::vector<Vec3> points, std::vector<double> spacings, double usual)
      : points_(std::move(points)), tree_(points_), spacings_(std::move(spacings)), usual_(usual) {}

  /// True if the point may be an outlier, now or once others are gone; false for most of a surface.
  bool is_suspect(std::uint32_t point) const {
    if (spacings_[point] > kIsolated * usual_) return true;
    const auto near = tree_.nearest_neighbours(points_[point], kSuspectNeighbours);
    return std::any_of(near.begin(), near.end(), [&](const PointTree::Neighbour& n) {
      return spacings_[point] > kIsolated * spacings_[n.point];
    });
  }

  bool is_outlier(std::uint32_t point) const {
    const std::vector<PointTree::Neighbour> around =
        tree_.nearest_neighbours(points_[point], kAround);
    const double spacing = kSpacingOfSixth * around[kSixth].distance;  // others may be gone
    return is_scattered(point, spacing, around) || is_off(point, spacing, around);
  }

 private:
  PlaneOf plane_without(std::uint32_t left_out, std::span<const PointTree::Neighbour> near) const {
    std::vector<Vec3> others;
    for (const PointTree::Neighbour& n : near) {
      if (n.point != left_out) others.push_back(points_[n.point]);
    }
    return plane_of(others);
  }

  bool is_scattered(std::uint32_t point, double spacing,
                    std::span<const PointTree::Neighbour> around) const {
    if (spacing < kScattered * usual_) return false;
    const PlaneOf plane = plane_without(point, around.first(kPlaneNeighbours));
    return plane.across > kThick * plane.along;
  }

  bool is_off(std::uint32_t point, double own, std::span<const PointTree::Neighbour> around) const {
    int witnesses = 0, off = 0;
    for (const PointTree::Neighbour& near : around) {
      const double spacing = spacings_[near.point];
      if (near.point == point || !(own > kIsolated * spacing)) continue;
      const PlaneOf plane =
          plane_without(point, tree_.nearest_neighbours(points_[near.point], kPlaneNeighbours));
      off += around[1].distance > kAlone * spacing &&
             plane.off(points_[point]) >
                 kOutlierSpacings * spacing + kOutlierDeviations * plane.across;
      if (++witnesses == kWitnesses) break;
    }
    return off == kWitnesses;
  }

  std::vector<Vec3> points_;
  PointTree tree_;
  std::vector<double> spacings_;
  double usual_;  ///< spacing, m
};

}  // namespace

std::vector<std::uint32_t> find_non_isolated_points(std::span<const Vec3> points) {
  std::vector<std::uint32_t> kept(points.size());
  std::iota(kept.begin(), kept.end(), 0u);
  if (points.size() <= kPlaneNeighbours) return kept;
  const std::vector<double> spacings = compute_local_spacings(points);
  const double usual = upper_median(spacings);
  std::vector<bool> suspect(points.size(), true);
  for (int round = 0; round < kOutlierRounds && kept.size() > kPlaneNeighbours; ++round) {
    std::vector<Vec3> left;
    std::vector<double> left_spacings;
    for (const std::uint32_t i : kept) {
      left.push_back(points[i]);
      left_spacings.push_back(spacings[i]);
    }
    const Isolation isolation(std::move(left), std::move(left_spacings), usual);
    std::vector<std::uint32_t> next;
    for (std::uint32_t i = 0; i < kept.size(); ++i) {
      if (round == 0) suspect[kept[i]] = isolation.is_suspect(i);
      if (!suspect[kept[i]] || !isolation.is_outlier(i)) next.push_back(kept[i]);
    }
    if (next.size() == kept.size()) break;
    kept = std::move(next);
  }
  return kept;
}

}  // namespace clast::reconstruct_detail
