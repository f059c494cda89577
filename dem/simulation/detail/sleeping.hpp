#pragma once
/// Which bodies of a world sleep, and what wakes them (docs/theory.md, Sleep).
#include <cstdint>
#include <span>

#include "dem/simulation/detail/contact_pair_table.hpp"

namespace clast::dem_detail {

/// Puts bodies to sleep and wakes them. What it changes is theirs: `WorldBody::asleep`, what was
/// left of their motion, and their watch.
class SleepManager {
 public:
  std::size_t count() const { return count_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(count_);
  }

  /// Wakes what a body in motion touches, and all that is asleep around it.
  /// @param pairs  with an up-to-date list of active ones; no other pair wakes anything
  void wake_touched(std::span<WorldBody> bodies, const ContactPairTable& pairs);
  /// Wakes a body that is about to go, and what it touches, with all that is asleep around them.
  void wake_around(std::uint32_t body, std::span<WorldBody> bodies, const ContactPairTable& pairs);
  /// Puts bodies to sleep that stay where they are, as do all that touch them.
  /// @param moving  numbers of the bodies that were not idle in the step, ascending
  /// @return  the kinetic energy that this takes from them, J
  double put_to_sleep(std::span<WorldBody> bodies, std::span<const std::uint32_t> moving,
                      const ContactPairTable& pairs);

 private:
  void wake(std::uint32_t body, std::span<WorldBody> bodies, const ContactPairTable& pairs);

  std::size_t count_ = 0;
};

}  // namespace clast::dem_detail
