#pragma once
/// Records the motion of one block of a sequence.
#include <cstddef>
#include <span>
#include <vector>

#include "dem/simulation/sequence.hpp"

namespace clast::dem_detail {

struct BlockRecorder {
  void record_step(const MotionStep& step);
  /// Records the blocks that it touches during its own release.
  void record_hits(std::span<const std::size_t> others);

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(result, touching, hit_blocks, first_rest);
  }

  SequenceResult result;
  bool touching = false;                ///< true if it had contact at the end of the last step
  std::vector<std::size_t> hit_blocks;  ///< blocks it touched during its own release, ascending
  Vec3 first_rest = Vec3::Zero();       ///< position at the end of its own release
};

}  // namespace clast::dem_detail
