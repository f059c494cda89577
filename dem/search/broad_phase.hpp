#pragma once
/// Broad phase: pairs of bodies with overlapping or nearly overlapping bounding spheres.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::dem_detail {

struct BoundingSphere {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool fixed = false;  ///< true if the body is fixed; two fixed bodies are not a pair
};

class BroadPhase {
  /// Pair of body indices, the smaller one first.
 public:
  using Pair = std::array<std::uint32_t, 2>;

  /// Updates the list of pairs if a body has moved by half the slack since the last update, or if
  /// the number of bodies has changed. The list then contains all pairs of overlapping spheres
  /// until the next update.
  /// @param slack  largest distance between two spheres of a listed pair, m; positive
  /// @param moved  bodies that may have moved since the last call; default: all
  /// @return true if the list was updated
  bool update_pairs(std::span<const BoundingSphere> spheres, double slack,
                    std::optional<std::span<const std::uint32_t>> moved = {});

  /// Returns the distance that a body may move before the list of pairs must be updated, m; 0 if
  /// there is no list.
  double remaining_displacement(std::size_t body, const Vec3& centre, double slack) const {
    return body < centres_.size() ? 0.5 * slack - (centre - centres_[body]).norm() : 0.0;
  }

  /// Returns the listed pairs of bodies, sorted. They include all pairs whose spheres overlapped at
  /// the last update.
  const std::vector<Pair>& pairs() const { return pairs_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(centres_, pairs_);
  }

  /// Centres of the spheres at the last update of the list.
 private:
  std::vector<Vec3> centres_;
  std::vector<Pair> pairs_;
};

}  // namespace clast::dem_detail
