#pragma once
/// Overlap of a block with the ground.
#include <memory>

#include "dem/motion/rigid_body.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

/// Measures the overlap of a body with a terrain at many poses, which share precomputed data.
class GroundOverlap {
 public:
  /// Stores references; both arguments must outlive this object.
  GroundOverlap(const TerrainSurface& terrain, const RigidBody& body);
  ~GroundOverlap();

  /// Returns the largest overlap of the body with the terrain, m; 0 without contact. It is also 0
  /// if the body is completely below the surface.
  double max_overlap(const RigidState& state) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
