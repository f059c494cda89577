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
                                   const BlocksOnGround& found) {
  ChosenBlock chosen = with_ground(found.blocks[found.central_block], points, ground);
  chosen.notes.push_back("the ground around it was found and removed");
  if (found.blocks.size() > 1) chosen.notes.push_back(note_other_blocks(found.blocks.size()));
  return chosen;
}

std::string note_other_blocks(std::size_t count) {
  return std::to_string(count) +
         " blocks stand on the ground; the one near the middle was used, `split` uses all of them";
}

void throw_only_ground_error(const std::string& name, double fraction) {
  throw GeometryError(name + ": the largest component is the ground (" +
                      format_significant(100.0 * fraction, 3) +
                      " % of the scan) and no object on it is a block; scan a block and "
                      "the ground around "
                      "it, or, if this is one block alone, use `find_ground = false`");
}

}  // namespace clast::reconstruct_detail
