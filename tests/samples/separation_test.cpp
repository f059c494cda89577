#include "samples/deposit/separation.hpp"

#include <gtest/gtest.h>

#include "mesh/triangle_tree.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

/// A ball of radius 0.5 m, its surface of many triangles.
VirtualBlock make_ball() {
  VirtualBlock block;
  block.core = ellipsoid(1.0, {0.5, 0.5, 0.5}, 0.0, 6);
  block.surface = core_mesh(block.core.shape);
  block.volume = signed_volume(block.surface);
  return block;
}

double largest_overlap(const std::vector<VirtualBlock>& blocks, const std::vector<Pose>& poses) {
  double largest = 0.0;
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    const TriangleMesh body = transformed(blocks[a].surface, poses[a]);
    const TriangleTree tree(body);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (a == b) continue;
      for (const Vec3& vertex : blocks[b].surface.vertices) {
        largest = std::max(largest, -tree.signed_distance(poses[b] * vertex));
      }
    }
  }
  return largest;
}

TEST(Separation, OverlapsFallBelowTheAllowedOne) {
  const std::vector<VirtualBlock> blocks(3, make_ball());
  std::vector<Pose> poses = {{{0, 0, 0.5}, Quat::Identity()},
                             {{0.93, 0, 0.5}, Quat::Identity()},
                             {{0.45, 0, 1.28}, Quat::Identity()}};
  const std::vector<Pose> before = poses;
  ASSERT_GT(largest_overlap(blocks, poses), 0.05);
  const double remaining = separate_surfaces(blocks, poses, 0.005, 1);
  EXPECT_LE(remaining, 0.005);
  EXPECT_NEAR(largest_overlap(blocks, poses), remaining, 1e-9);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((poses[i].translation - before[i].translation).norm(), 0.1);
  }
}

TEST(Separation, BlocksThatDoNotOverlapStay) {
  const std::vector<VirtualBlock> blocks(2, make_ball());
  std::vector<Pose> poses = {{{0, 0, 0.5}, Quat::Identity()}, {{1.01, 0, 0.5}, Quat::Identity()}};
  EXPECT_EQ(separate_surfaces(blocks, poses, 0.005, 1), 0.0);
  EXPECT_EQ(poses[1].translation, Vec3(1.01, 0, 0.5));
}

}  // namespace
}  // namespace clast
