#include "reconstruct/underside/detail/space_below.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/plan_geometry.hpp"

namespace clast::reconstruct_detail {

namespace {

/// The strip above the ground is at least so many cubes high.
constexpr double kMinCubes = 3.0;
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// Heights of the lowest sheet of a mesh over a grid in plan.
class LowestSheet {
 public:
  LowestSheet(const TriangleMesh& mesh, double side) : side_(side) {
    for (const Vec3& v : mesh.vertices) box_.include(v);
    columns_ = steps(box_.high.x() - box_.low.x());
    rows_ = steps(box_.high.y() - box_.low.y());
    lowest_.assign(columns_ * rows_, kNothing);
    for (const auto& [a, b, c] : mesh.triangles) {
      draw(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    }
  }
  std::size_t count() const { return lowest_.size(); }
  double height(std::size_t cell) const { return lowest_[cell]; }
  /// Middle of a cell, at a height.
  Vec3 position(std::size_t cell, double height) const {
    return {x(cell % columns_), y(cell / columns_), height};
  }

 private:
  std::size_t steps(double length) const { return static_cast<std::size_t>(length / side_) + 1; }
  double x(std::size_t column) const {
    return box_.low.x() + side_ * (static_cast<double>(column) + 0.5);
  }
  double y(std::size_t row) const {
    return box_.low.y() + side_ * (static_cast<double>(row) + 0.5);
  }
  std::size_t cell_of(double from, std::size_t count) const {
    return std::min(count - 1, static_cast<std::size_t>(std::max(0.0, from / side_)));
  }
  void draw(const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec2 plan_p = p.head<2>(), plan_q = q.head<2>(), plan_r = r.head<2>();
    const double whole = twice_area(plan_p, plan_q, plan_r);
    if (whole == 0.0) return;
    const Vec3 low = p.cwiseMin(q).cwiseMin(r) - box_.low;
    const Vec3 high = p.cwiseMax(q).cwiseMax(r) - box_.low;
    for (std::size_t j = cell_of(low.y(), rows_); j <= cell_of(high.y(), rows_); ++j) {
      for (std::size_t i = cell_of(low.x(), columns_); i <= cell_of(high.x(), columns_); ++i) {
        const Vec2 at(x(i), y(j));
        const double of_q = twice_area(plan_p, at, plan_r) / whole;
        const double of_r = twice_area(plan_p, plan_q, at) / whole;
        if (of_q < 0.0 || of_r < 0.0 || of_q + of_r > 1.0) continue;
        double& lowest = lowest_[j * columns_ + i];
        lowest = std::min(lowest, p.z() + of_q * (q.z() - p.z()) + of_r * (r.z() - p.z()));
      }
    }
  }

  double side_;
  Bounds box_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> lowest_;
};

}  // namespace

OccludedSpace measure_occluded_space(const TriangleMesh& closed, const Plane& ground, double strip,
                                     const FreeSpaceGrid& free_space) {
  const Quat upright = Quat::FromTwoVectors(ground.normal, Vec3::UnitZ());
  TriangleMesh standing = closed;
  for (Vec3& v : standing.vertices) v = upright * v - Vec3(0.0, 0.0, ground.distance);
  const double side = free_space.side, cell_area = side * side;
  strip = std::max(strip, kMinCubes * side);
  const LowestSheet sheet(standing, side);
  const auto empty = [&](std::size_t cell, double height) {
    const Vec3 position = sheet.position(cell, height) + Vec3(0.0, 0.0, ground.distance);
    return free_space.is_free(upright.conjugate() * position);
  };
  OccludedSpace below;
  for (std::size_t cell = 0; cell < sheet.count(); ++cell) {
    double height = sheet.height(cell);
    if (height == kNothing) continue;
    below.plan_area += cell_area;
    for (; height - side > strip; height -= side) {
      if (!empty(cell, height - 0.5 * side)) below.volume += side * cell_area;
    }
    if (height > strip && empty(cell, strip + 0.5 * side)) continue;
    below.base_area += cell_area;
    below.volume += std::max(0.0, height) * cell_area;
  }
  return below;
}

}  // namespace clast::reconstruct_detail
