#pragma once
/// How deep a placed block overlaps the ground.
#include <memory>

#include "dem/motion/rigid_body.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

/// Measures any number of placements of one rounded body over one terrain; what the search needs
/// of the body is made once.
class GroundOverlap {
 public:
  /// Both must outlive it.
  GroundOverlap(const TerrainSurface& terrain, const RigidBody& body);
  ~GroundOverlap();

  /// Largest overlap of any contact with the ground's skin, m; 0 when clear of it, and also when
  /// buried so deep that nothing reaches the surface.
  double max_overlap(const RigidState& state) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
