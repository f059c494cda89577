#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reconstruct/deposit/deposit.hpp"
#include "samples/deposit/deposit.hpp"
#include "samples/deposit/segmentation_score.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {
namespace {

/// A small virtual deposit, and the blocks that are found in it.
struct FoundDeposit {
  VirtualDeposit truth;
  Deposit found;
  SegmentationScore score;
};

FoundDeposit find_in(const DepositRecipe& recipe) {
  FoundDeposit result{make_deposit(recipe, {}, 0), {}, {}};
  std::vector<Vec3> points;
  std::vector<std::uint32_t> true_blocks;
  for (const ScannedPoint& p : result.truth.scan.points) {
    points.emplace_back(p.position.cast<double>());
    true_blocks.push_back(result.truth.scene.block_of_triangle[p.triangle]);
  }
  result.found = segment_deposit(points, {.threads = 0});
  std::vector<std::uint32_t> labels(points.size(), 0);
  for (std::uint32_t b = 0; b < result.found.blocks.size(); ++b) {
    for (const std::uint32_t i : result.found.blocks[b].points) labels[i] = b + 1;
  }
  result.score = score_segmentation(true_blocks, labels, result.truth.blocks);
  return result;
}

/// Median over the matched blocks of |ln(estimate / truth)| of L, I and the volume.
std::array<double, 3> median_errors(const FoundDeposit& deposit) {
  std::array<std::vector<double>, 3> errors;
  for (const BlockScore& score : deposit.score.blocks) {
    if (!score.eligible || !score.is_matched()) continue;
    const TrueBlock& truth = deposit.truth.blocks[score.block - 1];
    const TriangleMesh& body = deposit.found.blocks[score.proposal - 1].body;
    const Vec3 sides = smallest_box(body.vertices).lengths;
    errors[0].push_back(std::abs(std::log(sides[0] / truth.axes[0])));
    errors[1].push_back(std::abs(std::log(sides[1] / truth.axes[1])));
    errors[2].push_back(std::abs(std::log(signed_volume(body) / truth.volume)));
  }
  std::array<double, 3> medians{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::sort(errors[k].begin(), errors[k].end());
    medians[k] = errors[k].at(errors[k].size() / 2);
  }
  return medians;
}

TEST(DepositBlocks, OfAHeapAreFound) {
  const FoundDeposit heap = find_in({.kind = DepositKind::kHeap, .blocks = 50, .seed = 501});
  EXPECT_GE(heap.score.eligible, 30u);
  EXPECT_GE(heap.score.precision(), 0.9);
  EXPECT_GE(heap.score.recall(), 0.9);
  EXPECT_GE(heap.score.close_fraction(), 0.85);
  const auto [length, width, volume] = median_errors(heap);
  EXPECT_LT(length, 0.08);
  EXPECT_LT(width, 0.08);
  EXPECT_LT(volume, 0.18);
}

TEST(DepositBlocks, OnNaturalGroundAreFound) {
  const FoundDeposit ground = find_in({.kind = DepositKind::kNatural, .blocks = 14, .seed = 502});
  EXPECT_GE(ground.score.precision(), 0.9);
  EXPECT_GE(ground.score.recall(), 0.9);
}

}  // namespace
}  // namespace clast
