#pragma once
/// Broad phase: which bodies are near each other, as their bounding spheres overlap or soon might.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::dem_detail {

/// A body in the broad phase.
struct BoundingSphere {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool fixed = false;  ///< two fixed bodies are no pair
};

class BroadPhase {
 public:
  using Pair = std::array<std::uint32_t, 2>;  ///< smaller number first

  /// Lists the pairs again when a body has moved half the slack since the last time, or the number
  /// of bodies has changed; true then. Until that call the list held every pair of overlapping
  /// spheres.
  /// @param slack  how far spheres may be apart to be listed, m; above 0
  /// @param moved  those that may have moved since the last call; none given: all
  bool update_pairs(std::span<const BoundingSphere> spheres, double slack,
               std::optional<std::span<const std::uint32_t>> moved = {});

  /// How far a body may move on before the list may miss a pair of it, m; 0 before there is a list.
  double remaining_displacement(std::size_t body, const Vec3& centre, double slack) const {
    return body < centres_.size() ? 0.5 * slack - (centre - centres_[body]).norm() : 0.0;
  }

  /// Sorted; holds at least every pair of spheres that overlaps at the last `update_pairs`.
  const std::vector<Pair>& pairs() const { return pairs_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(centres_, pairs_);
  }

 private:
  std::vector<Vec3> centres_;  ///< when the list was made
  std::vector<Pair> pairs_;
};

}  // namespace clast::dem_detail
