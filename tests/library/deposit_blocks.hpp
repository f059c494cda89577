#pragma once
/// Blocks of scanned deposits for tests.
#include <string>
#include <vector>

#include "tests/library/block_samples.hpp"

namespace clast {

/// A block of a deposit: a cuboid of 3 x 2 x 1 m at a place.
inline Block deposit_block(const std::string& id, const Vec3& place) {
  Block block = filled_block(id);
  for (Vec3& vertex : block.surface.vertices) vertex += place;
  block.volume_bracket->intervals = {5.6, 6.8, {{2.9, 1.9, 0.9}, {3.1, 2.1, 1.1}}};
  block.deposit =
      DepositRecord{.points = 1200, .spacing = 0.05, .visible_fraction = 0.55, .confidence = 0.9};
  return block;
}

/// Twenty blocks of a deposit with I from 0.25 to 1.2 m, the small ones hardly resolved. The 90 %
/// intervals of L, I and S are 0.9 to 1.1 times the estimates.
inline std::vector<Block> deposit_of_sizes() {
  std::vector<Block> blocks;
  for (int k = 0; k < 20; ++k) {
    Block block = deposit_block("D" + std::to_string(k), Vec3::Zero());
    const double size = 0.25 + 0.05 * k;
    block.box.lengths = {1.5 * size, size, 0.7 * size};
    block.volume_bracket->intervals = {
        1.0, 2.0, {0.9 * block.box.lengths, 1.1 * block.box.lengths}};
    block.deposit->spacing = 0.0125;
    block.deposit->points = static_cast<std::size_t>((0.8 + 0.05 * (k % 7)) * size * size * 6400.0);
    blocks.push_back(block);
  }
  return blocks;
}

inline std::vector<const Block*> pointers_to(const std::vector<Block>& blocks) {
  std::vector<const Block*> pointers;
  for (const Block& block : blocks) pointers.push_back(&block);
  return pointers;
}

}  // namespace clast
