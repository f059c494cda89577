#pragma once
/// Neighbours of balls in a union, exposed points, and points where three spheres meet.
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast::particles_detail {

/// Intersecting balls of each ball, those with the deepest overlap first.
class BallNeighbours {
 public:
  explicit BallNeighbours(std::span<const Ball> balls);

  std::span<const std::uint32_t> of(std::size_t ball) const { return neighbours_[ball]; }
  /// True if a point on the sphere of `ball` is in no neighbour but `other`.
  bool is_exposed(std::span<const Ball> balls, std::size_t ball, const Vec3& point,
                  std::uint32_t other = kNoIndex) const {
    for (const std::uint32_t j : neighbours_[ball]) {
      if (j == other) continue;
      if ((point - balls[j].centre).squaredNorm() < balls[j].radius * balls[j].radius) return false;
    }
    return true;
  }

 private:
  std::vector<std::vector<std::uint32_t>> neighbours_;
};

/// Circle where the spheres of two balls meet.
struct SphereCircle {
  std::array<std::uint32_t, 2> balls;
  Vec3 centre, across, along;  ///< the last two are unit and perpendicular to the axis
  double radius = 0.0;

  /// Calls `visit(point)` for `count` points at equal angles from `start` on.
  template <class Visit>
  void visit_points(double start, int count, const Visit& visit) const {
    const double angle = 2.0 * kPi / count, cosine = std::cos(angle), sine = std::sin(angle);
    Vec2 turn(std::cos(start), std::sin(start));
    for (int k = 0; k < count; ++k) {
      visit(Vec3(centre + radius * (turn.x() * across + turn.y() * along)));
      turn = Vec2(cosine * turn.x() - sine * turn.y(), sine * turn.x() + cosine * turn.y());
    }
  }
};

/// Finds the circles of all pairs of intersecting spheres.
std::vector<SphereCircle> find_sphere_circles(std::span<const Ball> balls,
                                              const BallNeighbours& neighbours);

/// Returns point `k` of `count` on a spiral with equal areas on the unit sphere.
Vec3 spiral_direction(std::size_t k, std::size_t count);

/// Exposed point where the spheres of three balls meet.
struct SphereCorner {
  std::array<std::uint32_t, 3> balls;
  Vec3 point;
};

/// Finds the corners of the surface of a union of balls. The deepest notches between balls are
/// there.
std::vector<SphereCorner> find_sphere_corners(std::span<const Ball> balls,
                                              const BallNeighbours& neighbours);

}  // namespace clast::particles_detail
