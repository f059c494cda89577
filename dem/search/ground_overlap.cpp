#include "dem/search/ground_overlap.hpp"

#include <algorithm>

#include "dem/search/edge_penetration.hpp"
#include "dem/search/terrain_narrow_phase.hpp"
#include "dem/surface/terrain_impl.hpp"

namespace clast {

using namespace dem_detail;

struct GroundOverlap::Impl {
  Impl(const TerrainSurface& terrain, const RigidBody& of)
      : ground(terrain.impl().surface), body(of), surface(of.shape) {}
  const IndexedSurface& ground;
  const RigidBody& body;
  BlockSurface surface;
};

GroundOverlap::GroundOverlap(const TerrainSurface& terrain, const RigidBody& body)
    : impl_(std::make_unique<Impl>(terrain, body)) {}
GroundOverlap::~GroundOverlap() = default;

double GroundOverlap::max_overlap(const RigidState& state) const {
  const auto& [ground, body, surface] = *impl_;
  if (!ground.nearest_point(state.position, body.bounding_radius() + ground.radius)) return 0.0;
  TerrainNarrowPhase search(ground, surface, body.size());
  double deepest = 0.0;
  for (const ContactPoint& contact : search.find_contacts(state.world_from_body(), 0.0)) {
    deepest = std::max(deepest, contact.overlap);
  }
  return std::max(deepest, edge_penetration_depth(ground, surface, state.world_from_body()));
}

}  // namespace clast
