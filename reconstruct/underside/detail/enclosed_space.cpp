#include "reconstruct/underside/detail/enclosed_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace clast::reconstruct_detail {

namespace {

constexpr int kDepth = 4;  ///< halvings of a triangle's sides where planes meet behind it

/// A place on the closure carried on to the planes.
struct Carried {
  Vec3 way;             ///< from the centre to the closure
  double factor = 1.0;  ///< ... to be lengthened by
  std::size_t plane = 0;
};

class Space {
 public:
  Space(const Vec3& centre, std::span<const Plane> planes, double farthest)
      : centre_(centre), planes_(planes), farthest_(farthest) {
    for (const Plane& plane : planes)
      room_.push_back(std::max(0.0, -plane.signed_distance(centre)));
  }

  Carried carried(const Vec3& way) {
    Carried position{way, std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const double along = planes_[i].normal.dot(way);
      if (along * position.factor > room_[i]) position = {way, room_[i] / along, i};
    }
    bounded_ = bounded_ && position.factor * way.norm() <= farthest_;
    return position;
  }

  /// Factor by which a ray to the closure must be lengthened to reach a plane; at least 1.
  double factor(const Vec3& way, std::size_t plane) const {
    const double along = planes_[plane].normal.dot(way);
    if (!(along > 0.0)) return std::numeric_limits<double>::infinity();
    return std::max(1.0, room_[plane] / along);
  }

  void add(const Carried& a, const Carried& b, const Carried& c, int depth) {
    if (!bounded_) return;
    const bool one_plane = a.plane == b.plane && b.plane == c.plane;
    if (one_plane || depth == 0) {
      add_behind({a.way, b.way, c.way}, {a.plane, b.plane, c.plane});
      return;
    }
    const Carried ab = carried(0.5 * (a.way + b.way)), bc = carried(0.5 * (b.way + c.way)),
                  ca = carried(0.5 * (c.way + a.way));
    add(a, ab, ca, depth - 1);
    add(ab, b, bc, depth - 1);
    add(ca, bc, c, depth - 1);
    add(ab, bc, ca, depth - 1);
  }

  /// The space before each of the planes holds what is before all of them: the least counts.
  void add_behind(const std::array<Vec3, 3>& ways, const std::array<std::size_t, 3>& planes) {
    std::array<double, 3> least{};
    double product = std::numeric_limits<double>::infinity();
    for (const std::size_t plane : planes) {
      std::array<double, 3> factors{};
      for (std::size_t k = 0; k < 3; ++k) factors[k] = factor(ways[k], plane);
      if (const double own = factors[0] * factors[1] * factors[2]; own < product) {
        product = own;
        least = factors;
      }
    }
    bounded_ = bounded_ && std::isfinite(product);
    result.volume += ways[0].dot(ways[1].cross(ways[2])) / 6.0 * (product - 1.0);
    for (std::size_t k = 0; k < 3; ++k) result.points.push_back(centre_ + least[k] * ways[k]);
  }

  bool bounded() const { return bounded_; }
  EnclosedSpace result;

 private:
  Vec3 centre_;
  std::span<const Plane> planes_;
  double farthest_;
  std::vector<double> room_;
  bool bounded_ = true;
};

}  // namespace

std::optional<EnclosedSpace> compute_enclosed_space(std::span<const TriangleCorners> closure,
                                                    const Vec3& centre,
                                                    std::span<const Plane> planes,
                                                    double farthest) {
  Space space(centre, planes, farthest);
  for (const TriangleCorners& triangle : closure) {
    if (!space.bounded()) break;
    std::array<Carried, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = space.carried(triangle[k] - centre);
    space.add(corners[0], corners[1], corners[2], kDepth);
  }
  if (!space.bounded()) return std::nullopt;
  return std::move(space.result);
}

}  // namespace clast::reconstruct_detail
