#include "particles/detail/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "particles/detail/ball_contacts.hpp"

namespace clast::particles_detail {

namespace {

constexpr std::size_t kLeastSpherePoints = 24;
/// Cells of the grid of exposed points are this many spacings wide.
constexpr double kCellSpacings = 4.0;

/// Exposed points sorted into cells of a grid.
class PointGrid {
 public:
  PointGrid(std::span<const Vec3> points, double width) : width_(width) {
    for (const Vec3& point : points) box_.include(point);
    for (int axis = 0; axis < 3; ++axis) {
      size_[axis] = static_cast<std::int64_t>((box_.high[axis] - box_.low[axis]) / width) + 1;
    }
    entries_.reserve(points.size());
    for (const Vec3& point : points) entries_.emplace_back(index(cell(point)), point);
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    first_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]) + 1, 0);
    for (const auto& [at, point] : entries_) ++first_[static_cast<std::size_t>(at) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  }

  /// Distance of the nearest point, or any distance of a point below `enough`.
  double distance(const Vec3& place, double enough) const {
    double best = std::numeric_limits<double>::infinity();
    const Cell middle = cell(place);
    const std::int64_t most = std::max({size_[0], size_[1], size_[2]});
    for (std::int64_t ring = 0; ring <= most; ++ring) {
      if (best <= static_cast<double>(ring - 1) * width_) break;
      for_ring(middle, ring, [&](std::int64_t at) {
        for (std::size_t e = first_[static_cast<std::size_t>(at)];
             e < first_[static_cast<std::size_t>(at) + 1]; ++e) {
          best = std::min(best, (entries_[e].second - place).norm());
        }
      });
      if (best < enough) return best;
    }
    return best;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell(const Vec3& point) const {
    Cell result;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      result[k] = std::clamp<std::int64_t>(
          static_cast<std::int64_t>(std::floor((point[axis] - box_.low[axis]) / width_)), 0,
          size_[k] - 1);
    }
    return result;
  }
  std::int64_t index(const Cell& at) const { return (at[2] * size_[1] + at[1]) * size_[0] + at[0]; }
  template <class Visit>
  void for_ring(const Cell& middle, std::int64_t ring, const Visit& visit) const {
    Cell low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::max<std::int64_t>(middle[k] - ring, 0);
      high[k] = std::min(middle[k] + ring, size_[k] - 1);
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        const bool shell = std::abs(z - middle[2]) == ring || std::abs(y - middle[1]) == ring;
        for (std::int64_t x = low[0]; x <= high[0]; ++x) {
          if (shell || std::abs(x - middle[0]) == ring) visit(index({x, y, z}));
        }
      }
    }
  }

  double width_;
  Bounds box_;
  std::array<std::int64_t, 3> size_;
  std::vector<std::pair<std::int64_t, Vec3>> entries_;
  std::vector<std::size_t> first_;
};

std::vector<Vec3> exposed_points(std::span<const Ball> balls, double spacing) {
  const BallNeighbours neighbours(balls);
  std::vector<Vec3> points;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const double area = 4.0 * kPi * balls[b].radius * balls[b].radius;
    const auto count =
        std::max(kLeastSpherePoints, static_cast<std::size_t>(area / (spacing * spacing)));
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 point = balls[b].centre + balls[b].radius * spiral_direction(k, count);
      if (neighbours.is_exposed(balls, b, point)) points.push_back(point);
    }
  }
  for (const SphereCircle& circle : find_sphere_circles(balls, neighbours)) {
    const int count = std::max(4, static_cast<int>(2.0 * kPi * circle.radius / spacing));
    circle.visit_points(0.0, count, [&](const Vec3& point) {
      if (neighbours.is_exposed(balls, circle.balls[0], point, circle.balls[1])) {
        points.push_back(point);
      }
    });
  }
  for (const SphereCorner& corner : find_sphere_corners(balls, neighbours)) {
    points.push_back(corner.point);
  }
  return points;
}

}  // namespace

std::vector<Vec3> sample_body(const BodySurface& body, double spacing) {
  const auto count = static_cast<std::size_t>(body.area() / (spacing * spacing)) + 1;
  std::vector<Vec3> points = body.sample(count);
  for (const Vec3& corner : body.corners(count)) points.push_back(corner);
  return points;
}

LargestDistance measure_surface_distance(const BodySurface& body,
                                         std::span<const Vec3> body_samples,
                                         std::span<const Ball> balls, double spacing) {
  const std::vector<Vec3> exposed = exposed_points(balls, spacing);
  LargestDistance result;
  std::vector<Vec3> covered;
  for (const Vec3& point : body_samples) {
    double gap = std::numeric_limits<double>::infinity();
    for (const Ball& ball : balls) {
      gap = std::min(gap, (point - ball.centre).norm() - ball.radius);
    }
    if (gap < 0.0) covered.push_back(point);
    if (gap > result.value) result = {gap, point, true};
  }
  const LargestDistance rest = measure_covering_distance(body, covered, exposed, spacing);
  return rest.value > result.value ? rest : result;
}

LargestDistance measure_covering_distance(const BodySurface& body,
                                          std::span<const Vec3> covered_samples,
                                          std::span<const Vec3> exposed, double spacing) {
  LargestDistance result;
  const auto include = [&](double distance, const Vec3& place, bool is_on_body) {
    if (distance > result.value) result = {distance, place, is_on_body};
  };
  std::uint32_t hint = 0;
  for (const Vec3& point : exposed) {
    const BodySurface::Closest found = body.closest(point, hint);
    hint = found.triangle;
    include(std::abs(found.distance), point, false);
  }
  const PointGrid grid(exposed, kCellSpacings * spacing);
  for (const Vec3& point : covered_samples) {
    include(grid.distance(point, result.value), point, true);
  }
  return result;
}

}  // namespace clast::particles_detail
