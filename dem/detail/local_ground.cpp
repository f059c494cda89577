#include "dem/detail/local_ground.hpp"

#include <algorithm>
#include <cmath>

namespace clast {

GroundPlane plane_over(const IndexedSurface& ground, std::span<const std::uint32_t> faces) {
  const SurfaceFeatures& features = ground.features;
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t f : faces) sum += features.faces[f].normal;
  GroundPlane plane;
  if (sum.norm() > 0.0) plane.normal = sum.normalized();
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : features.faces[f].vertices) {
      plane.top = std::max(plane.top, plane.normal.dot(features.vertices[v]));
    }
  }
  return plane;
}

void LocalGround::gather(const IndexedSurface& ground, const Vec3& centre, double reach) {
  const SurfaceFeatures& features = ground.features;
  faces.clear();
  edges.clear();
  corners.clear();
  Bounds box;
  box.include(centre);
  std::vector<std::uint32_t> edges_met, corners_met;
  const std::vector<std::uint32_t> near = ground.faces_near(box, reach);
  for (const std::uint32_t f : near) {
    const SurfaceFace& face = features.faces[f];
    const Vec3& a = features.vertices[face.vertices[0]];
    const Vec3& b = features.vertices[face.vertices[1]];
    const Vec3& c = features.vertices[face.vertices[2]];
    const Vec3 middle = (a + b + c) / 3.0;
    const double radius = std::sqrt(std::max(
        {(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));
    if ((centre - middle).norm() > reach + radius) continue;
    faces.push_back({face.normal, face.normal.dot(a), middle, radius, f});
    for (int k = 0; k < 3; ++k) {
      if (features.edges[face.edges[k]].convex()) edges_met.push_back(face.edges[k]);
      if (features.pointed[face.vertices[k]]) corners_met.push_back(face.vertices[k]);
    }
  }
  const auto each_once = [](std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  };
  plane = plane_over(ground, near);
  each_once(edges_met);
  each_once(corners_met);
  for (const std::uint32_t e : edges_met) {
    const SurfaceEdge& edge = features.edges[e];
    edges.push_back({features.vertices[edge.vertices[0]], edge.direction, edge.length, e});
  }
  for (const std::uint32_t v : corners_met) corners.push_back({features.vertices[v], v});
}

}  // namespace clast
