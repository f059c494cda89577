#include "reconstruct/detail/choose_block_on_ground.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

namespace {

ChosenBlock with_ground(const BlockOnGround& block, const std::vector<Vec3>& points,
                        const Ground& ground) {
  ChosenBlock chosen{block.points, {}, block.centre, {}, {}};
  Bounds box;
  for (const std::uint32_t i : block.points) {
    chosen.points.push_back(points[i]);
    box.include(points[i]);
  }
  chosen.ground = ground.tangent_plane_below(block.centre, 0.5 * box.diagonal());
  return chosen;
}

}  // namespace

ChosenBlock choose_block_on_ground(const std::vector<Vec3>& points, const Ground& ground,
                                   const std::string& name) {
  const BlocksOnGround standing = find_blocks_on_ground(points, ground);
  const std::size_t count = standing.blocks.size();
  if (count == 0) {
    throw_only_ground_error(
        name, static_cast<double>(standing.ground.size()) / static_cast<double>(points.size()));
  }
  ChosenBlock chosen = with_ground(standing.blocks[standing.central_block], points, ground);
  chosen.notes.push_back("the ground around it was found and removed");
  if (count > 1) {
    chosen.notes.push_back(
        std::to_string(count) +
        " blocks stand on the ground; the one near the middle was used, `split` uses all of them");
  }
  return chosen;
}

void throw_only_ground_error(const std::string& name, double fraction) {
  throw GeometryError(name + ": the largest component is the ground (" +
                      format_significant(100.0 * fraction, 3) +
                      " % of the scan) and no object on it is a block; scan a block and "
                      "the ground around "
                      "it, or, if this is one block alone, use `find_ground = false`");
}

}  // namespace clast::reconstruct_detail
