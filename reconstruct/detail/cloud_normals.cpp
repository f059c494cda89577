#include "reconstruct/detail/cloud_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

#include "mesh/triangle_geometry.hpp"
#include "reconstruct/detail/cloud.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kBeside = 12;      ///< neighbours that a normal is compared with
constexpr double kAgrees = 0.5;  ///< cosine: 60 degrees

}  // namespace

void turn_outward(std::vector<Vec3>& normals, std::span<const Vec3> points) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  const NearestPoints tree(points);
  struct Step {
    double bend;
    std::uint32_t from, to;
    bool operator>(const Step& other) const {
      return bend != other.bend ? bend > other.bend
                                : std::pair(from, to) > std::pair(other.from, other.to);
    }
  };
  std::vector<std::vector<std::uint32_t>> beside(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (const auto& near : tree.nearest(points[i], kBeside)) {
      beside[i].push_back(near.point);
      beside[near.point].push_back(i);
    }
  }
  std::vector<bool> done(points.size(), false);
  std::vector<std::uint32_t> outermost(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) outermost[i] = i;
  std::stable_sort(outermost.begin(), outermost.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (points[a] - middle).squaredNorm() > (points[b] - middle).squaredNorm();
  });
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  const auto settle = [&](std::uint32_t point, const Vec3& like) {
    if (normals[point].dot(like) < 0.0) normals[point] = -normals[point];
    done[point] = true;
    for (const std::uint32_t next : beside[point]) {
      if (!done[next]) open.push({1.0 - std::abs(normals[point].dot(normals[next])), point, next});
    }
  };
  for (const std::uint32_t start : outermost) {  // a second component, if there is one, starts anew
    if (done[start]) continue;
    settle(start, points[start] - middle);
    while (!open.empty()) {
      const Step step = open.top();
      open.pop();
      if (!done[step.to]) settle(step.to, normals[step.from]);
    }
  }
}

std::size_t correct_normals(std::vector<Vec3>& normals, const TriangleMesh& surface) {
  std::vector<Vec3> areas(normals.size(), Vec3::Zero());
  for (const TriangleMesh::Triangle& t : surface.triangles) {
    const Vec3 area = area_vector(surface, t);
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
