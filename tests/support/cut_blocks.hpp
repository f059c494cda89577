#pragma once
/// Bodies of known shape, cut open at a ground in random poses.
#include <vector>

#include "core/random.hpp"
#include "massprops/solid.hpp"
#include "tests/support/cut_mesh.hpp"

namespace clast {

struct CutBlock {
  TriangleMesh open;    ///< what is above z = `level`
  double level = 0.0;   ///< m
  double buried = 0.0;  ///< share of the whole height
  double seen = 0.0;    ///< share of the whole area
  double volume = 0.0;  ///< of the whole body, m^3
};

/// `count` poses of `body`, from 2 to 25 % of the height buried.
inline std::vector<CutBlock> cut_blocks(const TriangleMesh& body, int count, std::uint64_t seed) {
  Random random(seed);
  const double volume = solid_mass_properties(body, 1.0).volume;
  std::vector<CutBlock> blocks;
  for (int i = 0; i < count; ++i) {
    const TriangleMesh turned = transformed(body, Pose{Vec3::Zero(), random.rotation()});
    const Bounds box = bounds(turned);
    CutBlock block;
    block.buried = random.uniform(0.02, 0.25);
    block.level = box.low.z() + block.buried * (box.high.z() - box.low.z());
    block.open = above_level(turned, block.level);
    block.seen = surface_area(block.open) / surface_area(turned);
    block.volume = volume;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace clast
