#pragma once
/// The gap or overlap between a placed block and the ground.
#include <memory>
#include <optional>

#include "dem/rigid_body.hpp"
#include "dem/terrain_surface.hpp"

namespace clast {

/// Measures any number of placements of one rounded body over one terrain; what the search needs
/// of the body is made once.
class GroundGap {
 public:
  /// Both must outlive it.
  GroundGap(const TerrainSurface& terrain, const RigidBody& body);
  ~GroundGap();

  /// Largest overlap of any contact with the ground's skin, m; 0 when clear of it, and also when
  /// buried so deep that nothing reaches the surface.
  double overlap(const RigidState& state) const;
  /// Smallest gap between the body and the ground's skin, m; negative when they overlap. None when
  /// farther than `reach`.
  std::optional<double> gap(const RigidState& state, double reach) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
