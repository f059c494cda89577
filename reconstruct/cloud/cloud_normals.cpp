#include "reconstruct/cloud/cloud_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "mesh/triangle_geometry.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kBeside = 12;      ///< neighbours that a normal is compared with
constexpr double kAgrees = 0.5;  ///< cosine: 60 degrees

/// The normal at `to` that follows from the one at `from`.
Vec3 carried_over(const Vec3& normal, const Vec3& from, const Vec3& to,
                  NormalPropagation propagation) {
  if (propagation == NormalPropagation::kParallel) return normal;
  const Vec3 way = (to - from).normalized();  // mirrored at the plane half way
  return normal - 2.0 * way.dot(normal) * way;
}

/// Above zero where normals face away from the middle of their points on the whole: of a closed
/// surface sampled evenly, three times its volume over its area, m.
double outward_share(std::span<const std::uint32_t> component, std::span<const Vec3> points,
                     std::span<const Vec3> normals) {
  const auto count = static_cast<double>(component.size());
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t i : component) middle += points[i] / count;
  double fraction = 0.0;
  for (const std::uint32_t i : component) fraction += normals[i].dot(points[i] - middle) / count;
  return fraction;
}

/// Finds the neighbours with which each point is compared; the relation is symmetric.
std::vector<std::vector<std::uint32_t>> points_beside(std::span<const Vec3> points) {
  const PointTree tree(points);
  std::vector<std::vector<std::uint32_t>> beside(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (const auto& near : tree.nearest_neighbours(points[i], kBeside)) {
      beside[i].push_back(near.point);
      beside[near.point].push_back(i);
    }
  }
  return beside;
}

std::vector<std::uint32_t> outermost_first(std::span<const Vec3> points, const Vec3& middle) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (points[a] - middle).squaredNorm() > (points[b] - middle).squaredNorm();
  });
  return order;
}

}  // namespace

void orient_outward(std::vector<Vec3>& normals, std::span<const Vec3> points,
                    NormalPropagation propagation) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  struct Step {
    double bending;
    std::uint32_t from, to;
    bool operator>(const Step& other) const {
      return bending != other.bending ? bending > other.bending
                                      : std::pair(from, to) > std::pair(other.from, other.to);
    }
  };
  const std::vector<std::vector<std::uint32_t>> beside = points_beside(points);
  std::vector<bool> done(points.size(), false);
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  std::vector<std::uint32_t> component;
  const auto settle = [&](std::uint32_t point, const Vec3& like) {
    if (normals[point].dot(like) < 0.0) normals[point] = -normals[point];
    done[point] = true;
    component.push_back(point);
    for (const std::uint32_t next : beside[point]) {
      if (done[next]) continue;
      const Vec3 carried = carried_over(normals[point], points[point], points[next], propagation);
      open.push({1.0 - std::abs(carried.dot(normals[next])), point, next});
    }
  };
  // A second component, if there is one, starts anew.
  for (const std::uint32_t start : outermost_first(points, middle)) {
    if (done[start]) continue;
    component.clear();
    settle(start, points[start] - middle);
    while (!open.empty()) {
      const Step step = open.top();
      open.pop();
      if (done[step.to]) continue;
      const Vec3& from = points[step.from];
      settle(step.to, carried_over(normals[step.from], from, points[step.to], propagation));
    }
    if (outward_share(component, points, normals) >= 0.0) continue;
    for (const std::uint32_t point : component) normals[point] = -normals[point];
  }
}

std::size_t correct_normals(std::vector<Vec3>& normals, const TriangleMesh& surface) {
  std::vector<Vec3> areas(normals.size(), Vec3::Zero());
  for (const TriangleMesh::Triangle& t : surface.triangles) {
    const Vec3 area = doubled_area_vector(surface, t);
    for (const std::uint32_t v : t) areas[v] += area;
  }
  std::size_t corrected = 0;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    if (!(areas[v].norm() > 0.0)) continue;
    const Vec3 facing = areas[v].normalized();
    if (normals[v].dot(facing) >= kAgrees) continue;
    normals[v] = facing;
    ++corrected;
  }
  return corrected;
}

}  // namespace clast::reconstruct_detail
