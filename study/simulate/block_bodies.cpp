#include "study/simulate/block_bodies.hpp"

#include <map>
#include <utility>

namespace clast {

RigidBody rigid_body(const Block& block) {
  return {.shape = transformed(block.body, block.source_from_body().inverse()),
          .mass = block.mass.mass,
          .moments = block.principal.moments,
          .smallest_side = block.axes().S};
}

BlockBodies::BlockBodies(const CampaignBlocks& choice) {
  for (const Block& block : choice.library) library_.push_back(rigid_body(block));
  std::map<std::pair<std::size_t, double>, std::uint32_t> first;
  for (const CampaignBlock& block : choice.blocks) {
    const auto number = static_cast<std::uint32_t>(blocks_.size());
    const std::uint32_t like =
        first.try_emplace({block.library, block.scale}, number).first->second;
    blocks_.push_back({block.library, block.scale, like});
  }
}

RigidBody BlockBodies::operator[](std::size_t block) const {
  return scaled(library_[blocks_[block].of_library], blocks_[block].scale);
}

}  // namespace clast
