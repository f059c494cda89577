#include "reconstruct/deposit/detail/oriented_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "core/statistics/statistics.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kGraphDegree = 32;          ///< about 3.2 spacings around
constexpr std::size_t kSpacingRank = 16;  ///< neighbour whose distance gives the spacing
constexpr double kSkyCell = 1.6;          ///< side of a cell of the depth buffers, in spacings
/// Depth below the highest point of a cell to which points count as visible, in cells.
constexpr double kSkyDepth = 2.0;
constexpr int kSignRounds = 4;                ///< rounds in which neighbours correct signs
constexpr std::size_t kPointsPerTask = 4096;  ///< points per parallel task

/// Calls `body(i)` for all points, in chunks.
template <class Body>
void for_all_points(std::size_t count, unsigned threads, const Body& body) {
  parallel_for((count + kPointsPerTask - 1) / kPointsPerTask, threads, [&](std::size_t chunk) {
    const std::size_t end = std::min(count, (chunk + 1) * kPointsPerTask);
    for (std::size_t i = chunk * kPointsPerTask; i < end; ++i) body(i);
  });
}

/// Unit normal of the plane through a point and its neighbours, either sign.
Vec3 plane_normal(const OrientedPoints& cloud, std::size_t point) {
  Vec3 centre = Vec3::Zero();
  const auto near = cloud.neighbours_of(point);
  for (const std::uint32_t n : near) centre += cloud.positions[n];
  centre /= static_cast<double>(near.size());
  Mat3 scatter = Mat3::Zero();
  for (const std::uint32_t n : near) {
    const Vec3 offset = cloud.positions[n] - centre;
    scatter += offset * offset.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(scatter);
  const Vec3 normal = solver.eigenvectors().col(0);
  return normal.allFinite() && normal.norm() > 0.5 ? Vec3(normal.normalized())
                                                   : Vec3(Vec3::UnitZ());
}

/// Directions of the upper hemisphere: the zenith and two rings of eight.
std::vector<Vec3> sky_directions() {
  std::vector<Vec3> directions = {Vec3::UnitZ()};
  for (const double zenith_angle : {kPi / 4.0, 5.0 * kPi / 12.0}) {
    for (int k = 0; k < 8; ++k) {
      const double azimuth = kPi / 4.0 * k;
      directions.push_back(Vec3(std::sin(zenith_angle) * std::cos(azimuth),
                                std::sin(zenith_angle) * std::sin(azimuth),
                                std::cos(zenith_angle)));
    }
  }
  return directions;
}

/// Marks the points that are visible from infinity along `direction`.
std::vector<std::uint8_t> find_visible_points(const OrientedPoints& cloud, const Vec3& direction) {
  const Quat rotation = Quat::FromTwoVectors(direction, Vec3::UnitZ());
  const double cell = rounded_side(kSkyCell * cloud.spacing);
  std::vector<Vec3> flat(cloud.size());
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    flat[i] = rotation * cloud.positions[i];
    low = low.cwiseMin(flat[i]);
    high = high.cwiseMax(flat[i]);
  }
  low = (low / cell).array().floor() * cell;
  const auto columns = static_cast<std::size_t>((high.x() - low.x()) / cell) + 1;
  const auto rows = static_cast<std::size_t>((high.y() - low.y()) / cell) + 1;
  const auto cell_of = [&](const Vec3& p) {
    return static_cast<std::size_t>((p.x() - low.x()) / cell) +
           columns * static_cast<std::size_t>((p.y() - low.y()) / cell);
  };
  std::vector<double> highest(columns * rows, -1e300);
  for (const Vec3& p : flat) highest[cell_of(p)] = std::max(highest[cell_of(p)], p.z());
  std::vector<std::uint8_t> visible(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    visible[i] = flat[i].z() >= highest[cell_of(flat[i])] - kSkyDepth * cell;
  }
  return visible;
}

/// Turns normals towards the directions from which their points are visible.
void orient_to_the_sky(OrientedPoints& cloud, unsigned threads) {
  const std::vector<Vec3> directions = sky_directions();
  std::vector<std::vector<std::uint8_t>> visible(directions.size());
  parallel_for(directions.size(), threads,
               [&](std::size_t d) { visible[d] = find_visible_points(cloud, directions[d]); });
  std::vector<double> signs(cloud.size(), 0.0);
  for_all_points(cloud.size(), threads, [&](std::size_t i) {
    double sum = 0.0, weight = 0.0;
    for (std::size_t d = 0; d < directions.size(); ++d) {
      if (!visible[d][i]) continue;
      sum += cloud.normals[i].dot(directions[d]);
      weight += 1.0;
    }
    if (weight > 0.0) signs[i] = sum / weight;
  });
  for (int round = 0; round < kSignRounds; ++round) {
    std::vector<double> next(cloud.size());
    for_all_points(cloud.size(), threads, [&](std::size_t i) {
      double sum = 0.0;
      for (const std::uint32_t n : cloud.neighbours_of(i)) {
        sum += cloud.normals[i].dot(cloud.normals[n]) * signs[n];
      }
      const double mean = sum / static_cast<double>(cloud.neighbour_count);
      next[i] = std::clamp(signs[i] + mean, -1.0, 1.0);
    });
    signs = std::move(next);
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool down = signs[i] < 0.0 || (signs[i] == 0.0 && cloud.normals[i].z() < 0.0);
    if (down) cloud.normals[i] = -cloud.normals[i];
  }
}

/// Mean sine of the heights of `others` above the tangent plane of a point.
struct SineSum {
  double sum = 0.0;
  std::size_t count = 0;

  void add(const OrientedPoints& cloud, std::size_t point, std::uint32_t other) {
    const Vec3 offset = cloud.positions[other] - cloud.positions[point];
    const double length = offset.norm();
    if (!(length > 0.0)) return;
    sum += offset.dot(cloud.normals[point]) / length;
    ++count;
  }
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0.0; }
};

double concavity_at(const OrientedPoints& cloud, std::size_t point) {
  SineSum near, far;
  const auto neighbours = cloud.neighbours_of(point);
  for (const std::uint32_t n : neighbours) near.add(cloud, point, n);
  // The outermost neighbours of the eight outermost neighbours lie about twice as far.
  const std::size_t k = cloud.neighbour_count;
  for (std::size_t a = k - 8; a < k; ++a) {
    const auto onwards = cloud.neighbours_of(neighbours[a]);
    for (std::size_t b = k - 4; b < k; ++b) {
      if (onwards[b] != point) far.add(cloud, point, onwards[b]);
    }
  }
  return 0.5 * (near.mean() + far.mean());
}

}  // namespace

double rounded_side(double length) {
  constexpr double kStepsPerOctave = 4.0;
  return std::exp2(std::round(kStepsPerOctave * std::log2(length)) / kStepsPerOctave);
}

OrientedPoints orient_points(std::span<const Vec3> points, const Vec3& origin, unsigned threads) {
  OrientedPoints cloud;
  cloud.origin = origin;
  cloud.positions.reserve(points.size());
  for (const Vec3& p : points) cloud.positions.push_back(p - cloud.origin);
  cloud.neighbour_count = std::min<std::size_t>(kGraphDegree, points.size() - 1);
  cloud.neighbours.resize(points.size() * cloud.neighbour_count);
  cloud.spacings.resize(points.size());
  cloud.normals.resize(points.size());
  cloud.concavities.resize(points.size());
  const PointTree tree(cloud.positions);
  for_all_points(points.size(), threads, [&](std::size_t i) {
    const auto near =
        tree.nearest_neighbours(cloud.positions[i], static_cast<int>(cloud.neighbour_count) + 1);
    std::size_t count = 0;
    double distance = 0.0;
    for (const PointTree::Neighbour& n : near) {
      if (n.point == i || count == cloud.neighbour_count) continue;
      cloud.neighbours[i * cloud.neighbour_count + count++] = n.point;
      if (count == kSpacingRank) distance = n.distance;
    }
    cloud.spacings[i] = distance * std::sqrt(kPi / static_cast<double>(kSpacingRank));
  });
  cloud.spacing = upper_median(cloud.spacings);
  for_all_points(points.size(), threads,
                 [&](std::size_t i) { cloud.normals[i] = plane_normal(cloud, i); });
  orient_to_the_sky(cloud, threads);
  for_all_points(points.size(), threads,
                 [&](std::size_t i) { cloud.concavities[i] = concavity_at(cloud, i); });
  return cloud;
}

}  // namespace clast::reconstruct_detail
