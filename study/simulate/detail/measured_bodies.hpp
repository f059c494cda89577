#pragma once
/// Rigid body with precomputed data for computing its overlap with the ground.
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "dem/search/ground_overlap.hpp"
#include "study/simulate/block_bodies.hpp"

namespace clast::study_detail {

struct GroundOverlapBody {
  GroundOverlapBody(const TerrainSurface& ground, RigidBody of_block)
      : body(std::move(of_block)), overlap(ground, body) {}
  GroundOverlapBody(const GroundOverlapBody&) = delete;
  GroundOverlapBody& operator=(const GroundOverlapBody&) = delete;

  RigidBody body;
  GroundOverlap overlap;
};

/// Cache of bodies with precomputed data for their overlap with the ground. It stores up to 500
/// bodies and is cleared when full.
class GroundOverlapBodyCache {
 public:
  /// Makes an empty cache. Both arguments must outlive it.
  GroundOverlapBodyCache(const TerrainSurface& ground, const BlockBodies& bodies)
      : ground_(ground), bodies_(bodies) {}

  /// Returns the body of a block. The reference is valid until the next call.
  const GroundOverlapBody& of(std::size_t block) {
    const std::uint32_t first = bodies_.first_equal_body(block);
    const auto found = kept_.find(first);
    if (found != kept_.end()) return *found->second;
    if (kept_.size() == kMaxRetained) kept_.clear();
    return *kept_.emplace(first, std::make_unique<GroundOverlapBody>(ground_, bodies_[block]))
                .first->second;
  }

 private:
  static constexpr std::size_t kMaxRetained = 500;
  const TerrainSurface& ground_;
  const BlockBodies& bodies_;
  std::map<std::uint32_t, std::unique_ptr<GroundOverlapBody>> kept_;  ///< key: `first_equal_body`
};

}  // namespace clast::study_detail
