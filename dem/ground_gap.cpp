#include "dem/ground_gap.hpp"

#include <algorithm>

#include "dem/detail/contact_search.hpp"
#include "dem/detail/pierced_depth.hpp"
#include "dem/detail/segment_distance.hpp"
#include "dem/detail/terrain_impl.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// Vertices, edges and faces of the ground near the block, each once.
struct NearbyGround {
  std::vector<std::uint32_t> vertices, edges;
};

NearbyGround nearby(const IndexedSurface& ground, const Bounds& box, double reach) {
  NearbyGround found;
  for (const std::uint32_t f : ground.faces_near(box, reach)) {
    const SurfaceFace& face = ground.features.faces[f];
    found.vertices.insert(found.vertices.end(), face.vertices.begin(), face.vertices.end());
    found.edges.insert(found.edges.end(), face.edges.begin(), face.edges.end());
  }
  for (std::vector<std::uint32_t>* list : {&found.vertices, &found.edges}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return found;
}

}  // namespace

struct GroundGap::Impl {
  Impl(const TerrainSurface& terrain, const RigidBody& of)
      : ground(terrain.impl().surface), body(of), surface(of.shape) {}
  const IndexedSurface& ground;
  const RigidBody& body;
  BlockSurface surface;
};

GroundGap::GroundGap(const TerrainSurface& terrain, const RigidBody& body)
    : impl_(std::make_unique<Impl>(terrain, body)) {}
GroundGap::~GroundGap() = default;

double GroundGap::overlap(const RigidState& state) const {
  const auto& [ground, body, surface] = *impl_;
  if (!ground.nearest(state.position, body.bounding_radius() + ground.radius)) return 0.0;
  ContactSearch search(ground, surface, body.size());
  double deepest = 0.0;
  for (const ContactPoint& contact : search.contacts(state.world_from_body(), 0.0)) {
    deepest = std::max(deepest, contact.overlap);
  }
  return std::max(deepest, pierced_depth(ground, surface, state.world_from_body()));
}

std::optional<double> GroundGap::gap(const RigidState& state, double reach) const {
  const auto& [ground, body, surface] = *impl_;
  if (const double deepest = overlap(state); deepest > 0.0) return -deepest;
  const Pose world_from_body = state.world_from_body();
  const SurfaceFeatures& block = surface.features;
  const double radii = body.shape.radius + ground.radius;
  double nearest = reach + radii;
  std::vector<Vec3> corners;
  Bounds box;
  for (const Vec3& vertex : block.vertices) {
    corners.push_back(world_from_body * vertex);
    box.include(corners.back());
    if (const auto hit = ground.nearest(corners.back(), nearest)) {
      nearest = std::min(nearest, hit->distance);
    }
  }
  const NearbyGround around = nearby(ground, box, nearest);
  const Pose body_from_world = world_from_body.inverse();
  for (const std::uint32_t v : around.vertices) {
    const Vec3 in_body = body_from_world * ground.features.vertices[v];
    for (std::uint32_t f = 0; f < block.faces.size(); ++f) {
      nearest = std::min(nearest, std::abs(nearest_on_face(block, f, in_body).distance));
    }
  }
  for (const SurfaceEdge& edge : block.edges) {
    const Vec3 along = world_from_body.rotation * edge.direction;
    for (const std::uint32_t g : around.edges) {
      const SurfaceEdge& other = ground.features.edges[g];
      nearest = std::min(nearest, segment_distance(corners[edge.vertices[0]], along, edge.length,
                                                   ground.features.vertices[other.vertices[0]],
                                                   other.direction, other.length));
    }
  }
  if (nearest >= reach + radii) return std::nullopt;
  return nearest - radii;
}

}  // namespace clast
