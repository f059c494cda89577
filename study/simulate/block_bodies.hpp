#pragma once
/// Rigid bodies of the blocks of a campaign.
#include <cstdint>
#include <vector>

#include "dem/motion/rigid_body.hpp"
#include "study/simulate/block_choice.hpp"

namespace clast {

RigidBody rigid_body(const Block& block);

/// Rigid bodies of all blocks of a campaign. One body is stored per library block; scaled bodies
/// are made on access.
class BlockBodies {
 public:
  BlockBodies() = default;
  explicit BlockBodies(const CampaignBlocks& choice);

  std::size_t size() const { return blocks_.size(); }
  /// Makes the scaled body of a block.
  /// @param block  index into CampaignBlocks::blocks
  RigidBody operator[](std::size_t block) const;
  std::uint32_t first_equal_body(std::size_t block) const {
    return blocks_[block].first_equal_body;
  }

 private:
  struct ScaledBody {
    std::size_t of_library;
    double scale;
    std::uint32_t first_equal_body;
  };
  std::vector<RigidBody> library_;
  std::vector<ScaledBody> blocks_;
};

}  // namespace clast
