#include "particles/detail/ball_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast::particles_detail {

namespace {

/// Squared sine of the angle between planes of two circles below which these are parallel.
constexpr double kParallel = 1e-12;

/// Directions of the points of a spiral with equal areas: (cos, sin) of k golden angles.
class SpiralTurns {
 public:
  SpiralTurns() : turns_(kKept) {
    for (std::size_t k = 0; k < kKept; ++k) turns_[k] = computed(k);
  }
  Vec2 at(std::size_t k) const { return k < kKept ? turns_[k] : computed(k); }

 private:
  static constexpr std::size_t kKept = 8192;

  static Vec2 computed(std::size_t k) {
    static const double kGoldenAngle = kPi * (3.0 - std::sqrt(5.0));
    const double angle = kGoldenAngle * static_cast<double>(k);
    return {std::cos(angle), std::sin(angle)};
  }

  std::vector<Vec2> turns_;
};

}  // namespace

BallNeighbours::BallNeighbours(std::span<const Ball> balls) : neighbours_(balls.size()) {
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    found.clear();
    for (std::uint32_t j = 0; j < balls.size(); ++j) {
      const double reach = balls[i].radius + balls[j].radius;
      const double squared = (balls[i].centre - balls[j].centre).squaredNorm();
      if (j == i || squared >= reach * reach) continue;
      found.emplace_back(std::sqrt(squared) - reach, j);
    }
    std::sort(found.begin(), found.end());
    for (const auto& [depth, j] : found) neighbours_[i].push_back(j);
  }
}

std::vector<SphereCircle> find_sphere_circles(std::span<const Ball> balls,
                                              const BallNeighbours& neighbours) {
  std::vector<SphereCircle> circles;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    for (const std::uint32_t j : neighbours.of(i)) {
      if (j < i) continue;
      const Ball &a = balls[i], &b = balls[j];
      const Vec3 offset = b.centre - a.centre;
      const double distance = offset.norm();
      const double height =
          0.5 * (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance);
      const double squared = a.radius * a.radius - height * height;
      if (!(squared > 0.0)) continue;
      const Vec3 axis = offset / distance, across = axis.unitOrthogonal();
      circles.push_back(
          {{i, j}, a.centre + height * axis, across, axis.cross(across), std::sqrt(squared)});
    }
  }
  return circles;
}

Vec3 spiral_direction(std::size_t k, std::size_t count) {
  const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / static_cast<double>(count);
  static const SpiralTurns kTurns;
  const Vec2 turn = std::sqrt(1.0 - z * z) * kTurns.at(k);
  return {turn.x(), turn.y(), z};
}

std::vector<SphereCorner> find_sphere_corners(std::span<const Ball> balls,
                                              const BallNeighbours& neighbours) {
  std::vector<SphereCorner> corners;
  const auto outside_others = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                  const Vec3& point) {
    for (const std::uint32_t other : neighbours.of(i)) {
      if (other == j || other == k) continue;
      const double radius = balls[other].radius;
      if ((point - balls[other].centre).squaredNorm() < radius * radius) return false;
    }
    return true;
  };
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const Ball& a = balls[i];
    const std::span<const std::uint32_t> near = neighbours.of(i);
    for (const std::uint32_t j : near) {
      if (j < i) continue;
      // Plane of the circle of i and j: u . x = p, relative to the centre of i.
      const Vec3 u = balls[j].centre - a.centre;
      const double uu = u.squaredNorm();
      const double p = 0.5 * (uu + a.radius * a.radius - balls[j].radius * balls[j].radius);
      if (p * p >= a.radius * a.radius * uu) continue;
      for (const std::uint32_t k : near) {
        if (k < j) continue;
        const Vec3 v = balls[k].centre - a.centre;
        const double reach = balls[j].radius + balls[k].radius;
        if (k == j || (v - u).squaredNorm() >= reach * reach) continue;
        const double q =
            0.5 * (v.squaredNorm() + a.radius * a.radius - balls[k].radius * balls[k].radius);
        const Vec3 line = u.cross(v);
        const double squared = line.squaredNorm();
        if (squared <= kParallel * uu * v.squaredNorm()) continue;
        const Vec3 foot = (p * v.cross(line) + q * line.cross(u)) / squared;
        const double rest = a.radius * a.radius - foot.squaredNorm();
        if (rest <= 0.0) continue;
        const Vec3 along = std::sqrt(rest / squared) * line;
        for (const Vec3& point : {Vec3(a.centre + foot + along), Vec3(a.centre + foot - along)}) {
          if (outside_others(i, j, k, point)) corners.push_back({{i, j, k}, point});
        }
      }
    }
  }
  return corners;
}

}  // namespace clast::particles_detail
