#pragma once
/// The gap between a placed block and the ground, over all pairs of features that can be nearest.
#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "dem/search/ground_overlap.hpp"
#include "dem/search/terrain_narrow_phase.hpp"
#include "dem/surface/segment_distance.hpp"
#include "dem/surface/terrain_impl.hpp"

namespace clast {

/// Smallest gap between the body and the ground's skin, m; negative when they overlap. None when
/// farther than `reach`.
inline std::optional<double> ground_gap(const TerrainSurface& terrain, const RigidBody& body,
                                        const RigidState& state, double reach) {
  using namespace dem_detail;
  const double deepest = GroundOverlap(terrain, body).max_overlap(state);
  if (deepest > 0.0) return -deepest;
  const IndexedSurface& ground = terrain.impl().surface;
  const BlockSurface surface(body.shape);
  const SurfaceFeatures& block = surface.features;
  const Pose world_from_body = state.world_from_body(), body_from_world = world_from_body.inverse();
  const double radii = body.shape.radius + ground.radius;
  double nearest = reach + radii;
  std::vector<Vec3> corners;
  Bounds box;
  for (const Vec3& vertex : block.vertices) {
    corners.push_back(world_from_body * vertex);
    box.include(corners.back());
    if (const auto hit = ground.nearest_point(corners.back(), nearest)) {
      nearest = std::min(nearest, hit->distance);
    }
  }
  std::set<std::uint32_t> vertices, edges;
  for (const std::uint32_t f : ground.find_faces_near(box, nearest)) {
    const SurfaceFace& face = ground.features.faces[f];
    vertices.insert(face.vertices.begin(), face.vertices.end());
    edges.insert(face.edges.begin(), face.edges.end());
  }
  for (const std::uint32_t v : vertices) {
    const Vec3 in_body = body_from_world * ground.features.vertices[v];
    for (std::uint32_t f = 0; f < block.faces.size(); ++f) {
      nearest = std::min(nearest, std::abs(nearest_point_on_face(block, f, in_body).distance));
    }
  }
  for (const SurfaceEdge& edge : block.edges) {
    const Vec3 along = world_from_body.rotation * edge.direction;
    for (const std::uint32_t g : edges) {
      const SurfaceEdge& other = ground.features.edges[g];
      const ClosestSegmentPoints closest = closest_segment_points(
          {corners[edge.vertices[0]], along, edge.length},
          {ground.features.vertices[other.vertices[0]], other.direction, other.length});
      nearest = std::min(nearest, closest.separation.norm());
    }
  }
  if (nearest >= reach + radii) return std::nullopt;
  return nearest - radii;
}

}  // namespace clast
