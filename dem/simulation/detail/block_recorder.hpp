#pragma once
/// Records the motion of one block in a simulation of several blocks.
#include <cstddef>
#include <span>
#include <vector>

#include "dem/simulation/sequence.hpp"

namespace clast::dem_detail {

struct BlockRecorder {
  void record_step(const MotionStep& step);
  /// Records other blocks that the block touches during its own release.
  void record_hits(std::span<const std::size_t> others);

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(result, touching, hit_blocks, first_rest);
  }

  SequenceResult result;
  bool touching = false;  ///< true if the block had contact at the end of the last step
  /// Ascending indices of the blocks that it touched during its own release.
  std::vector<std::size_t> hit_blocks;
  Vec3 first_rest = Vec3::Zero();  ///< position of the block at the end of its own release
};

}  // namespace clast::dem_detail
