#pragma once
/// Sleeping bodies of a world (docs/theory.md, Sleep).
#include <cstdint>
#include <span>

#include "dem/simulation/detail/contact_pair_table.hpp"

namespace clast::dem_detail {

/// Puts stationary bodies to sleep and wakes them, so that sleeping bodies need no computing time.
class SleepManager {
 public:
  std::size_t count() const { return count_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(count_);
  }

  /// Wakes sleeping bodies touched by bodies that are not stationary, and all sleeping bodies
  /// connected to those by contacts.
  /// @param pairs  pairs with an up-to-date active list; only active pairs are examined
  void wake_touched(std::span<WorldBody> bodies, const ContactPairTable& pairs);
  /// Wakes a body that will be removed, the bodies that it touches, and all sleeping bodies
  /// connected to those by contacts.
  void wake_around(std::uint32_t body, std::span<WorldBody> bodies, const ContactPairTable& pairs);
  /// Puts each stationary body to sleep if all bodies that it touches are stationary too.
  /// @param moving  ascending indices of the bodies that moved in the step
  /// @return kinetic energy removed by setting velocities to zero, J
  double put_to_sleep(std::span<WorldBody> bodies, std::span<const std::uint32_t> moving,
                      const ContactPairTable& pairs);

 private:
  void wake(std::uint32_t body, std::span<WorldBody> bodies, const ContactPairTable& pairs);

  std::size_t count_ = 0;
};

}  // namespace clast::dem_detail
