// Libraries of the blocks that joints cut from a mass.
#include "library/rock_mass_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "mesh/triangle_tree.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

RockMassOptions joints(std::initializer_list<const char*> sets) {
  RockMassOptions options;
  for (const char* set : sets) options.joints.push_back(parse_joint_set(set));
  return options;
}

const BlockSource kScarSource{"scar.ply", std::string(64, '0'), "units=m", ""};

TEST(RockMassBlocks, RoundedPiecesStayInsideTheirPlaces) {
  const TriangleMesh mass = rock_mesh(10, {3.0, 2.5, 2.0}, 5);
  RockMassOptions options = joints({"70/095/1.3/0.3", "60/200/1.1/0.3", "20/310/0.9"});
  options.cutting.min_volume = 0.05;
  const RockMassBlocks made = cut_rock_mass(mass, kScarSource, options);
  const JointedRockMass cut = cut_by_joints(mass, options.joints, options.cutting);
  ASSERT_EQ(made.blocks.size() + made.failures.size(), cut.blocks.size());
  EXPECT_LT(made.failures.size(), 3u);
  EXPECT_EQ(made.blocks[0].id, "J0001");
  EXPECT_TRUE(made.blocks[0].source.options.find("joints=70/95/1.3/0.3,60/200/1.1/0.3,20/310/0.9/0 "
                                                 "least_volume_m3=0.05 seed=1") !=
              std::string::npos)
      << made.blocks[0].source.options;
  EXPECT_NEAR(made.volume, signed_volume(mass), 1e-9);
  EXPECT_LT(made.block_volume, cut.block_volume);
  EXPECT_GT(made.block_volume, 0.985 * cut.block_volume);  // less what is rounded off
  for (const Block& block : made.blocks) {
    const std::size_t piece = std::stoul(block.id.substr(1)) - 1;
    const TriangleTree tree(cut.blocks[piece]);
    for (const Vec3& vertex : rounded_surface_mesh(block.body).vertices) {
      EXPECT_LT(tree.signed_distance(vertex), 1e-3 * block.axes().S) << block.id;
    }
    EXPECT_NEAR(block.mass.mass, block.density * block.mass.volume, 1e-9 * block.mass.mass);
  }
}

TEST(RockMassBlocks, OfABoxAreBoxesWithTheirClasses) {
  const RockMassBlocks made =
      cut_rock_mass(box_mesh({4.0, 3.0, 3.0}), kScarSource, joints({"90/90/4", "90/0/1", "0/0/1"}));
  for (const Block& block : made.blocks) {
    EXPECT_EQ(block.body.vertices.size(), 8u);
    EXPECT_EQ(block.body.faces.size(), 6u);
    EXPECT_LT(block.axes().S, 1.0 + 1e-9);
  }
  EXPECT_NEAR(made.block_volume, 36.0, 0.1);
}

// Several masses in a row; one that is too small for a block is among the failures, unless all are.
TEST(RockMassBlocks, OfSeveralMassesAreNumberedInARow) {
  const RockMassOptions options = joints({"0/0/1", "90/0/1"});
  TriangleMesh far = box_mesh({2.0, 2.0, 2.0});
  for (Vec3& vertex : far.vertices) vertex.x() += 50.0;
  const TriangleMesh near = box_mesh({3.0, 3.0, 3.0}), tiny = box_mesh({0.05, 0.05, 0.05});
  const RockMassBlocks one = cut_rock_mass(near, kScarSource, options);
  const RockMassBlocks two = cut_rock_mass(far, kScarSource, options);
  const RockMassBlocks all = cut_rock_masses(std::vector{near, tiny, far}, kScarSource, options);
  ASSERT_EQ(all.blocks.size(), one.blocks.size() + two.blocks.size());
  for (std::size_t i = 0; i < all.blocks.size(); ++i) {
    const bool first = i < one.blocks.size();
    const Block& alone = first ? one.blocks[i] : two.blocks[i - one.blocks.size()];
    EXPECT_EQ(std::stoul(all.blocks[i].id.substr(1)), i + 1);
    EXPECT_EQ(all.blocks[i].mass.volume, alone.mass.volume);
    EXPECT_EQ(all.blocks[i].mass.centre, alone.mass.centre);
  }
  EXPECT_NEAR(all.volume, 27.0 + 8.0 + 0.05 * 0.05 * 0.05, 1e-9);
  ASSERT_EQ(all.failures.size(), 1u);
  EXPECT_TRUE(all.failures[0].starts_with("mass 2: ")) << all.failures[0];
  EXPECT_THROW(cut_rock_masses(std::vector{tiny, tiny}, kScarSource, options), InputError);
}

// Far from the origin the same comes out, but for which of two vertices that nearly coincide stays.
TEST(RockMassBlocks, KeepTheirDigitsOnTheMap) {
  TriangleMesh mass = rock_mesh(6, {2.0, 1.5, 1.2}, 5);
  const RockMassOptions options = joints({"70/095/1.3", "60/200/1.1"});
  const RockMassBlocks here = cut_rock_mass(mass, kScarSource, options);
  const Vec3 far(652000.0, 5203000.0, 1800.0);
  for (Vec3& vertex : mass.vertices) vertex += far;
  const RockMassBlocks there = cut_rock_mass(mass, kScarSource, options);
  ASSERT_EQ(here.blocks.size(), there.blocks.size());
  for (std::size_t i = 0; i < here.blocks.size(); ++i) {
    const Block &a = here.blocks[i], &b = there.blocks[i];
    EXPECT_NEAR(b.mass.volume, a.mass.volume, 1e-4 * a.mass.volume);
    EXPECT_LT((b.mass.centre - far - a.mass.centre).norm(), 1e-4);
    EXPECT_LT((b.principal.moments - a.principal.moments).norm(),
              1e-4 * a.principal.moments.norm());
    EXPECT_NEAR(b.axes().S, a.axes().S, 1e-4);
  }
}

TEST(RockMassBlocks, AreTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mass = rock_mesh(6, {2.0, 1.5, 1.2}, 5);
  RockMassOptions options = joints({"70/095/1.0/0.2", "60/200/0.8"});
  options.threads = 1;
  const RockMassBlocks one = cut_rock_mass(mass, kScarSource, options);
  options.threads = 2;
  std::size_t reported = 0;
  options.progress = [&](const ProgressUpdate& step) {
    EXPECT_EQ(step.done, ++reported);
    EXPECT_EQ(step.total, one.blocks.size() + one.failures.size());
  };
  const RockMassBlocks two = cut_rock_mass(mass, kScarSource, options);
  ASSERT_EQ(one.blocks.size(), two.blocks.size());
  for (std::size_t i = 0; i < one.blocks.size(); ++i) {
    EXPECT_EQ(one.blocks[i].body.vertices, two.blocks[i].body.vertices);
    EXPECT_EQ(one.blocks[i].mass.mass, two.blocks[i].mass.mass);
  }
}

}  // namespace
}  // namespace clast
