#include "benchmarks/particles/clump_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include "core/random.hpp"

namespace clast {

namespace {

constexpr std::size_t kVolumePoints = 10'000'000, kSurfacePoints = 100'000;

bool is_inside(std::span<const Ball> balls, const Vec3& point) {
  return std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
    return (point - ball.centre).squaredNorm() < ball.radius * ball.radius;
  });
}

MassProperties union_by_points(std::span<const Ball> balls, Random& random, double& deviation) {
  Bounds box;
  for (const Ball& ball : balls) {
    box.include(ball.centre.array() - ball.radius);
    box.include(ball.centre.array() + ball.radius);
  }
  const Vec3 size = box.high - box.low;
  double count = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (std::size_t i = 0; i < kVolumePoints; ++i) {
    const Vec3 point =
        box.low + Vec3(random.uniform(), random.uniform(), random.uniform()).cwiseProduct(size);
    if (!is_inside(balls, point)) continue;
    count += 1.0;
    first += point;
    second += point * point.transpose();
  }
  MassProperties result;
  const double part = count / static_cast<double>(kVolumePoints);
  result.mass = result.volume = size.prod() * part;
  result.centre = first / count;
  const Mat3 moments = result.mass * (second / count - result.centre * result.centre.transpose());
  result.inertia = moments.trace() * Mat3::Identity() - moments;
  deviation = std::sqrt((1.0 - part) / count);
  return result;
}

/// Random points of the surface of a mesh.
std::vector<Vec3> random_points(const TriangleMesh& mesh, Random& random) {
  std::vector<double> sums;
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) sums.push_back(sum += triangle_area(mesh, triangle));
  std::vector<Vec3> points;
  while (points.size() < kSurfacePoints) {
    const auto at = std::upper_bound(sums.begin(), sums.end(), random.uniform() * sum);
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(at - sums.begin())];
    double s = random.uniform(), t = random.uniform();
    if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
    points.push_back(mesh.vertices[a] + s * (mesh.vertices[b] - mesh.vertices[a]) +
                     t * (mesh.vertices[c] - mesh.vertices[a]));
  }
  return points;
}

/// Random points of the surface of a union.
std::vector<Vec3> random_points(std::span<const Ball> balls, Random& random) {
  std::vector<double> sums;
  double sum = 0.0;
  for (const Ball& ball : balls) sums.push_back(sum += ball.radius * ball.radius);
  std::vector<Vec3> points;
  while (points.size() < kSurfacePoints) {
    const auto at = std::upper_bound(sums.begin(), sums.end(), random.uniform() * sum);
    const auto own = static_cast<std::size_t>(at - sums.begin());
    const Vec3 point = balls[own].centre + balls[own].radius * random.unit_vector();
    const bool hidden = std::any_of(balls.begin(), balls.end(), [&](const Ball& other) {
      return &other != &balls[own] &&
             (point - other.centre).squaredNorm() < other.radius * other.radius;
    });
    if (!hidden) points.push_back(point);
  }
  return points;
}

/// Points by cells of a grid, for the nearest of them.
class Cells {
 public:
  Cells(std::span<const Vec3> points, double width) : width_(width) {
    for (const Vec3& point : points) cells_[key(cell(point))].push_back(point);
  }
  double nearest(const Vec3& point) const {
    const Eigen::Vector3i middle = cell(point);
    double best = std::numeric_limits<double>::infinity();
    for (int ring = 0; best > (ring - 1) * width_; ++ring) {
      for (int x = -ring; x <= ring; ++x) {
        for (int y = -ring; y <= ring; ++y) {
          const bool shell = std::abs(x) == ring || std::abs(y) == ring;
          for (int z = -ring; z <= ring; z += shell || ring == 0 ? 1 : 2 * ring) {
            const auto found = cells_.find(key(middle + Eigen::Vector3i(x, y, z)));
            if (found == cells_.end()) continue;
            for (const Vec3& other : found->second) best = std::min(best, (other - point).norm());
          }
        }
      }
    }
    return best;
  }

 private:
  Eigen::Vector3i cell(const Vec3& point) const {
    return (point / width_).array().floor().cast<int>();
  }
  static std::int64_t key(const Eigen::Vector3i& at) {
    return (static_cast<std::int64_t>(at.x()) * 100'003 + at.y()) * 100'003 + at.z();
  }

  double width_;
  std::unordered_map<std::int64_t, std::vector<Vec3>> cells_;
};

}  // namespace

ClumpCheck check_clump(const ParticleBody& body, const TriangleTree& tree,
                       std::span<const Ball> balls, std::uint64_t seed) {
  Random random(seed);
  ClumpCheck check;
  check.errors =
      compare_mass_properties(union_by_points(balls, random, check.volume_deviation), body.mass);
  double largest = 0.0;
  const std::vector<Vec3> own = random_points(balls, random);
  for (const Vec3& point : own) {
    largest = std::max(largest, std::sqrt(tree.closest_point(point).squared_distance));
  }
  const Cells cells(own, 0.02 * body.length);
  for (const Vec3& point : random_points(body.mesh, random)) {
    largest = std::max(largest, cells.nearest(point));
  }
  check.errors.surface = largest / body.length;
  return check;
}

}  // namespace clast
