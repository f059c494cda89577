#pragma once
/// The rigid bodies of a campaign's blocks.
#include <cstdint>
#include <vector>

#include "dem/motion/rigid_body.hpp"
#include "study/simulate/block_choice.hpp"

namespace clast {

/// A block as the dynamics sees it.
RigidBody rigid_body(const Block& block);

/// Keeps one body for each block of the library. The scaled body of a block is made each time it is
/// asked for, since a campaign may draw hundreds of thousands of blocks, each of its own size.
class BlockBodies {
 public:
  BlockBodies() = default;
  explicit BlockBodies(const BlockChoice& choice);

  std::size_t size() const { return blocks_.size(); }
  /// The body of a block of `BlockChoice::blocks`, scaled.
  RigidBody operator[](std::size_t block) const;
  /// The first block that has the same body.
  std::uint32_t first_equal_body(std::size_t block) const { return blocks_[block].first_equal_body; }

 private:
  struct Scaled {
    std::size_t of_library;
    double scale;
    std::uint32_t first_equal_body;
  };
  std::vector<RigidBody> library_;
  std::vector<Scaled> blocks_;
};

}  // namespace clast
