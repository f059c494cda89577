#include "samples/deposit/deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/triangle_tree.hpp"
#include "samples/deposit/deposit_ground.hpp"
#include "samples/deposit/segmentation_score.hpp"
#include "samples/deposit/settling.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

/// Names a kind in the name of a test.
void PrintTo(DepositKind kind, std::ostream* out);
void PrintTo(DepositKind kind, std::ostream* out) { *out << name_of(kind); }

namespace {

/// Few blocks of similar size and few points, so that a test is short.
DepositRecipe small_recipe(DepositKind kind) {
  return {.kind = kind, .blocks = 6, .seed = 5, .size_ratio = 2.0, .spacings_per_block = 8.0};
}

double distance_from(const TriangleMesh& mesh, const Vec3& point) {
  return std::sqrt(TriangleTree(mesh).closest_point(point).squared_distance);
}

class DepositOfKind : public testing::TestWithParam<DepositKind> {};

TEST_P(DepositOfKind, PointsLieOnTheBodyThatTheyName) {
  const DepositRecipe recipe = small_recipe(GetParam());
  const VirtualDeposit deposit = make_deposit(recipe, {}, 1);
  ASSERT_EQ(deposit.bodies.size(), recipe.blocks);
  const double noise = recipe.noise * recipe.spacing();
  std::vector<std::size_t> counts(recipe.blocks + 1, 0);
  for (const ScannedPoint& point : deposit.scan.points) {
    const std::uint32_t block = deposit.scene.block_of_triangle[point.triangle];
    if (++counts[block] % 50 != 0 || block == 0) continue;
    EXPECT_LT(distance_from(deposit.bodies[block - 1], point.position.cast<double>()), 5.5 * noise);
  }
  for (const TrueBlock& truth : deposit.blocks) {
    const TriangleMesh& body = deposit.bodies[truth.block - 1];
    EXPECT_EQ(truth.points, counts[truth.block]);
    EXPECT_NEAR(truth.volume, signed_volume(body), 1e-9 * truth.volume);
    EXPECT_GE(truth.axes[0], truth.axes[1]);
    EXPECT_GE(truth.visible_fraction, 0.0);
    EXPECT_LE(truth.visible_fraction, 1.0);
    const Bounds box = bounds(body);
    EXPECT_TRUE((truth.centre.array() > box.low.array()).all());
    EXPECT_TRUE((truth.centre.array() < box.high.array()).all());
  }
  EXPECT_LE(deposit.largest_overlap, 0.5 * recipe.spacing());
}

TEST_P(DepositOfKind, ThreadsDoNotChangeIt) {
  const DepositRecipe recipe = small_recipe(GetParam());
  const VirtualDeposit one = make_deposit(recipe, {}, 1), two = make_deposit(recipe, {}, 2);
  ASSERT_EQ(one.scan.points.size(), two.scan.points.size());
  for (std::size_t i = 0; i < one.scan.points.size(); ++i) {
    ASSERT_EQ(one.scan.points[i].position, two.scan.points[i].position);
    ASSERT_EQ(one.scan.points[i].triangle, two.scan.points[i].triangle);
  }
  for (std::size_t b = 0; b < one.blocks.size(); ++b) {
    EXPECT_EQ(one.bodies[b].vertices, two.bodies[b].vertices);
    EXPECT_EQ(one.blocks[b].visible_fraction, two.blocks[b].visible_fraction);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, DepositOfKind,
                         testing::Values(DepositKind::kHeap, DepositKind::kSlope,
                                         DepositKind::kNatural),
                         [](const auto& kind) { return name_of(kind.param); });

TEST(Deposit, BlocksRestOnTheFloorOrOnOthers) {
  const DepositRecipe recipe = small_recipe(DepositKind::kHeap);
  const std::vector<VirtualBlock> blocks =
      make_deposit_blocks(recipe, count_released_blocks(recipe), {}, 1);
  const std::vector<std::optional<Pose>> poses = settle_blocks(recipe, blocks, 1);
  std::vector<TriangleMesh> bodies;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (poses[i]) bodies.push_back(transformed(blocks[i].surface, *poses[i]));
  }
  ASSERT_EQ(bodies.size(), recipe.blocks);
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    double gap = bounds(bodies[a]).low.z();
    EXPECT_GT(gap, -0.03);  // deviation of core and surface
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (a == b) continue;
      const TriangleTree tree(bodies[b]);
      for (const Vec3& vertex : bodies[a].vertices) {
        gap = std::min(gap, tree.signed_distance(vertex));
      }
    }
    EXPECT_LT(gap, 0.03);
  }
}

TEST(Deposit, TheSpacingChangesSurfacesAndNotWhereBlocksLie) {
  DepositRecipe recipe = small_recipe(DepositKind::kHeap);
  const auto settle = [&] {
    return settle_blocks(recipe, make_deposit_blocks(recipe, count_released_blocks(recipe), {}, 1),
                         1);
  };
  const std::vector<std::optional<Pose>> coarse = settle();
  recipe.spacings_per_block *= 2.0;
  const std::vector<std::optional<Pose>> fine = settle();
  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    ASSERT_EQ(coarse[i].has_value(), fine[i].has_value());
    if (!coarse[i]) continue;
    EXPECT_EQ(coarse[i]->translation, fine[i]->translation);
    EXPECT_TRUE(coarse[i]->rotation.coeffs() == fine[i]->rotation.coeffs());
  }
}

TEST(Deposit, FewBlocksOfVeryDifferentSizesMakeAHeap) {
  DepositRecipe recipe = small_recipe(DepositKind::kHeap);
  recipe.size_ratio = 8.0;
  recipe.seed = 8;  // a long block, larger than the heap of all of them
  for (const std::size_t count : {1, 3}) {
    recipe.blocks = count;
    const std::vector<std::optional<Pose>> poses =
        settle_blocks(recipe, make_deposit_blocks(recipe, count_released_blocks(recipe), {}, 1), 1);
    EXPECT_EQ(std::count_if(poses.begin(), poses.end(), [](const auto& pose) { return pose; }),
              static_cast<std::ptrdiff_t>(count));
  }
}

TEST(Deposit, NaturalRocksRiseTenSpacingsAboveTheGroundAtTheirCentres) {
  DepositRecipe recipe = small_recipe(DepositKind::kNatural);
  recipe.blocks = 12;
  const std::vector<VirtualBlock> blocks = make_deposit_blocks(recipe, recipe.blocks, {}, 1);
  const NaturalScene scene = make_natural_scene(recipe, blocks, 1);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Bounds body = bounds(transformed(blocks[i].surface, scene.poses[i]));
    const Vec2 centre = scene.poses[i].translation.head<2>();
    double nearest = 1e300, ground = 0.0;
    for (const Vec3& vertex : scene.ground.vertices) {
      const double aside = (vertex.head<2>() - centre).squaredNorm();
      if (aside >= nearest) continue;
      nearest = aside;
      ground = vertex.z();
    }
    EXPECT_GT(body.high.z() - ground, 10.0 * recipe.spacing());
    EXPECT_LT(body.low.z(), ground);  // it stands in the ground
  }
}

TEST(Deposit, SizesFollowThePowerLaw) {
  Random random(1);
  const std::vector<double> sizes = draw_block_sizes(4000, 8.0, random);
  for (const double factor : {1.5, 2.0, 4.0}) {
    double larger = 0.0;
    for (const double size : sizes) larger += size > factor * kSmallestBlock ? 1.0 : 0.0;
    const double expected = (std::pow(factor, -2.0) - 1.0 / 64.0) / (1.0 - 1.0 / 64.0);
    EXPECT_NEAR(larger / 4000.0, expected, 1.0 / 4000.0 + 1e-12);
  }
}

TEST(Deposit, FilesAreReadAsTheyWereWritten) {
  const VirtualDeposit deposit = make_deposit(small_recipe(DepositKind::kNatural), {}, 1);
  const ScratchFolder folder;
  write_deposit(deposit, folder / "d", false);
  const std::vector<TrueBlock> blocks = read_true_blocks(folder / "d");
  ASSERT_EQ(blocks.size(), deposit.blocks.size());
  EXPECT_EQ(blocks[2].axes, deposit.blocks[2].axes);
  EXPECT_EQ(blocks[2].visible_fraction, deposit.blocks[2].visible_fraction);
  EXPECT_EQ(blocks[2].shape, deposit.blocks[2].shape);
  const LabelledCloud truth = read_labelled_cloud(folder / "d/truth.ply");
  ASSERT_EQ(truth.points.size(), deposit.scan.points.size());
  EXPECT_EQ(truth.points[7], deposit.scan.points[7].position.cast<double>());
}

TEST(Deposit, ItsTruthScoresOne) {
  const DepositRecipe recipe{
      .kind = DepositKind::kScattered, .blocks = 3, .seed = 2, .size_ratio = 1.5};
  const ScratchFolder folder;
  write_deposit(make_deposit(recipe, {}, 1), folder / "d", false);
  LabelledCloud labelled = read_labelled_cloud(folder / "d/truth.ply");
  const LabelledCloud truth = labelled;
  std::reverse(labelled.points.begin(), labelled.points.end());
  std::reverse(labelled.blocks.begin(), labelled.blocks.end());
  const SegmentationScore score = score_segmentation(
      truth.blocks, align_labels(truth, labelled, 1e-4), read_true_blocks(folder / "d"));
  EXPECT_EQ(score.eligible, 3u);
  EXPECT_EQ(score.precision(), 1.0);
  EXPECT_EQ(score.recall(), 1.0);
  EXPECT_EQ(score.close_fraction(), 1.0);
}

TEST(DepositRecipe, BadValuesAreRefused) {
  EXPECT_TRUE(contains(refusal([] { parse_deposit_kind("pile"); }),
                       "\"pile\" is unknown; known are heap, scattered, slope, natural"));
  EXPECT_TRUE(contains(refusal([] { parse_scan_stations("boat"); }), "known are drone, tripod"));
  EXPECT_TRUE(contains(refusal([] { DepositRecipe{.blocks = 0}.check(); }), "blocks is 0"));
  EXPECT_TRUE(contains(refusal([] { DepositRecipe{.noise = -0.1}.check(); }), "noise is -0.1"));
  EXPECT_TRUE(contains(refusal([] { DepositRecipe{.fines = 2.0}.check(); }), "fines is 2"));
  const DepositRecipe natural{.kind = DepositKind::kNatural, .fines = 0.3};
  EXPECT_TRUE(contains(refusal([&] { natural.check(); }), "natural ground has soil of its own"));
}

}  // namespace
}  // namespace clast
