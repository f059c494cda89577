#include "reconstruct/deposit/deposit_edits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using Labels = std::vector<std::uint32_t>;
using EditKind = DepositEditKind;

/// Points of a row of square blocks of 10 x 10 points with a spacing of 0.1 m. Block b lies at x
/// from b - 1 to b; ground lies beyond the last.
struct BlockRow {
  explicit BlockRow(std::uint32_t blocks) {
    for (std::uint32_t b = 1; b <= blocks + 1; ++b) {
      for (int i = 0; i < 100; ++i) {
        points.push_back({b - 1 + 0.05 + 0.1 * (i % 10), 0.05 + 0.1 * (i / 10), 0.2});
        labels.push_back(b <= blocks ? b : 0);
      }
    }
  }
  static Vec3 on(std::uint32_t block, double y = 0.5) { return {block - 0.5, y, 0.2}; }
  EditedLabels edited(const std::vector<DepositEdit>& edits) const {
    return apply_deposit_edits(labels, points, 0.1, edits);
  }
  std::uint32_t label_near(const Labels& after, const Vec3& place) const {
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
          return (a - place).squaredNorm() < (b - place).squaredNorm();
        });
    return after[static_cast<std::size_t>(nearest - points.begin())];
  }

  std::vector<Vec3> points;
  Labels labels;
};

DepositEdit cut(const Vec3& block, std::vector<Vec3> line, const Vec3& view = -Vec3::UnitZ()) {
  return {EditKind::kCut, {block}, std::move(line), view};
}

TEST(DepositEdits, NoEditsChangeNothing) {
  const BlockRow row(3);
  const EditedLabels after = row.edited({});
  EXPECT_EQ(after.labels, row.labels);
  EXPECT_EQ(after.accepted_by, (std::vector<std::size_t>{0, 0, 0, 0}));
  EXPECT_TRUE(after.misfits.empty());
}

TEST(DepositEdits, ADroppedBlockIsGroundAndTheOthersAreNumberedWithoutGaps) {
  const BlockRow row(3);
  const EditedLabels after = row.edited({{EditKind::kDrop, {BlockRow::on(2)}}});
  EXPECT_EQ(row.label_near(after.labels, BlockRow::on(1)), 1u);
  EXPECT_EQ(row.label_near(after.labels, BlockRow::on(2)), 0u);
  EXPECT_EQ(row.label_near(after.labels, BlockRow::on(3)), 2u);
  EXPECT_EQ(after.sources, (Labels{0, 1, 3}));
}

TEST(DepositEdits, MergedBlocksAreOne) {
  const BlockRow row(4);
  const EditedLabels after =
      row.edited({{EditKind::kMerge, {BlockRow::on(4), BlockRow::on(1), BlockRow::on(2)}}});
  for (const std::uint32_t block : {1u, 2u, 4u}) {
    EXPECT_EQ(row.label_near(after.labels, BlockRow::on(block)), 1u) << block;
  }
  EXPECT_EQ(row.label_near(after.labels, BlockRow::on(3)), 2u);
  EXPECT_EQ(std::count(after.labels.begin(), after.labels.end(), 1u), 300);
}

TEST(DepositEdits, ACutDividesOneBlockAlongItsLine) {
  const BlockRow row(2);
  // The line ends inside of the block and is extended, but the block beside it is not cut.
  const EditedLabels after =
      row.edited({cut(BlockRow::on(1), {{0.2, 0.31, 0.0}, {0.6, 0.31, 0.0}})});
  EXPECT_EQ(std::count(after.labels.begin(), after.labels.end(), 1u), 30);
  EXPECT_EQ(std::count(after.labels.begin(), after.labels.end(), 3u), 70);
  EXPECT_EQ(std::count(after.labels.begin(), after.labels.end(), 2u), 100);
  EXPECT_EQ(row.label_near(after.labels, {0.5, 0.1, 0.2}), 1u) << "with the first point";
  EXPECT_EQ(after.sources, (Labels{0, 1, 2, 1}));
}

TEST(DepositEdits, ACutFollowsTheCornersOfItsLine) {
  const BlockRow row(1);
  // A quarter of the block is inside of the corner, however sharp or blunt it is at its end.
  const EditedLabels after =
      row.edited({cut(BlockRow::on(1), {{0.5, -1.0, 0.0}, {0.5, 0.5, 0.0}, {2.0, 0.5, 0.0}})});
  for (std::size_t i = 0; i < 100; ++i) {
    const bool inside = row.points[i].x() > 0.5 && row.points[i].y() < 0.5;
    EXPECT_EQ(after.labels[i], inside ? 2u : 1u) << row.points[i].transpose();
  }
}

TEST(DepositEdits, ACutContainsTheLinesOfSight) {
  std::vector<Vec3> points;  // a wall of 1 m x 1 m in the plane y = 0
  for (int i = 0; i < 100; ++i)
    points.push_back({0.05 + 0.1 * (i % 10), 0.0, 0.05 + 0.1 * (i / 10)});
  const Labels labels(100, 1);
  const DepositEdit edit =
      cut({0.5, 0.0, 0.5}, {{0.0, -5.0, 0.5}, {1.0, -5.0, 0.5}}, Vec3::UnitY());
  const Labels after = apply_deposit_edits(labels, points, 0.1, std::vector{edit}).labels;
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(after[i], points[i].z() < 0.5 ? 1u : 2u);
  // Seen from above, the line is in front of the whole wall.
  DepositEdit plan = edit;
  plan.view = -Vec3::UnitZ();
  EXPECT_EQ(apply_deposit_edits(labels, points, 0.1, std::vector{plan}).misfits.size(), 1u);
}

TEST(DepositEdits, EachActsOnTheResultOfThoseBefore) {
  const BlockRow row(3);
  // A side of a cut block is merged with its neighbour, and the other side is dropped.
  const EditedLabels after = row.edited({cut(BlockRow::on(1), {{0.0, 0.5, 0.0}, {1.0, 0.5, 0.0}}),
                                         {EditKind::kMerge, {{0.5, 0.75, 0.2}, BlockRow::on(2)}},
                                         {EditKind::kDrop, {{0.5, 0.25, 0.2}}}});
  EXPECT_TRUE(after.misfits.empty());
  EXPECT_EQ(row.label_near(after.labels, {0.5, 0.25, 0.2}), 0u);
  EXPECT_EQ(row.label_near(after.labels, {0.5, 0.75, 0.2}), 1u);
  EXPECT_EQ(row.label_near(after.labels, BlockRow::on(2)), 1u);
  EXPECT_EQ(row.label_near(after.labels, BlockRow::on(3)), 2u);
}

TEST(DepositEdits, OfDifferentBlocksMayBeInterchanged) {
  const BlockRow row(9);
  std::vector<DepositEdit> edits = {{EditKind::kAccept, {BlockRow::on(1)}},
                                    {EditKind::kDrop, {BlockRow::on(2)}},
                                    {EditKind::kMerge, {BlockRow::on(3), BlockRow::on(4)}},
                                    cut(BlockRow::on(5), {{4.0, 0.5, 0.0}, {5.0, 0.5, 0.0}}),
                                    cut(BlockRow::on(6), {{5.5, 0.0, 0.0}, {5.5, 1.0, 0.0}}),
                                    {EditKind::kMerge, {BlockRow::on(9), BlockRow::on(7)}}};
  const EditedLabels first = row.edited(edits);
  const auto accepted = [](const EditedLabels& after) {
    std::vector<bool> is_accepted;
    for (const std::size_t number : after.accepted_by) is_accepted.push_back(number > 0);
    return is_accepted;
  };
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = edits.size(); i-- > 1;)
      std::swap(edits[i], edits[random.uniform_index(i + 1)]);
    const EditedLabels after = row.edited(edits);
    EXPECT_EQ(after.labels, first.labels);
    EXPECT_EQ(after.sources, first.sources);
    EXPECT_EQ(accepted(after), accepted(first));
  }
}

TEST(DepositEdits, AcceptanceEndsWithTheNextChangeOfTheBlock) {
  const BlockRow row(3);
  const DepositEdit accept{EditKind::kAccept, {BlockRow::on(2)}};
  EXPECT_EQ(row.edited({accept}).accepted_by, (std::vector<std::size_t>{0, 0, 1, 0}));
  EXPECT_EQ(
      row.edited({accept, {EditKind::kMerge, {BlockRow::on(2), BlockRow::on(1)}}}).accepted_by,
      (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_EQ(
      row.edited({{EditKind::kMerge, {BlockRow::on(2), BlockRow::on(1)}}, accept}).accepted_by,
      (std::vector<std::size_t>{0, 2, 0}));
}

TEST(DepositEdits, APlaceNearABlockNamesIt) {
  const BlockRow row(2);
  const Vec3 above = BlockRow::on(2) + Vec3(0.0, 0.0, 0.4);  // four spacings
  EXPECT_EQ(row.edited({{EditKind::kDrop, {above}}}).sources, (Labels{0, 1}));
}

TEST(DepositEdits, ThatFitNothingAreRefusedByName) {
  const BlockRow row(2);
  const auto refused = [&](const std::vector<DepositEdit>& edits) {
    const EditedLabels after = row.edited(edits);
    return refusal([&] { check_edits_fit(edits, after.misfits); });
  };
  const DepositEdit fits{EditKind::kAccept, {BlockRow::on(1)}};
  EXPECT_EQ(refused({fits, {EditKind::kDrop, {{0.5, 0.5, 3.0}}}}),
            "edit 2 of 2 (drop at (0.5, 0.5, 3)): no point of the scan is within 0.5 m of (0.5, "
            "0.5, 3); name a block by a point on its surface, or remove the edit");
  EXPECT_TRUE(contains(refused({{EditKind::kMerge, {BlockRow::on(1), BlockRow::on(3)}}}),
                       "only ground is at (2.5, 0.5, 0.2), no block"));
  EXPECT_TRUE(contains(refused({{EditKind::kMerge, {BlockRow::on(1), BlockRow::on(1, 0.7)}}}),
                       "edit 1 of 1 (merge at (0.5, 0.5, 0.2)): its points are on one block"));
  EXPECT_TRUE(contains(refused({cut(BlockRow::on(1), {{0.0, 1.5, 0.0}, {1.0, 1.5, 0.0}})}),
                       "its line leaves the whole block on one side"));
}

TEST(DepositEdits, ThatAreInvalidAreRefusedByName) {
  const BlockRow row(2);
  const Vec3 place = BlockRow::on(1);
  const auto refused = [&](const DepositEdit& edit) {
    return refusal([&] { row.edited({edit}); });
  };
  EXPECT_TRUE(contains(refused({EditKind::kMerge, {place}}),
                       "edit 1 of 1 (merge at (0.5, 0.5, 0.2)): points: 1 point, but `merge` needs "
                       "two or more"));
  EXPECT_TRUE(contains(refused({EditKind::kDrop, {}}), "points: 0 points, but `drop` needs one"));
  EXPECT_TRUE(contains(refused({EditKind::kAccept, {Vec3::Constant(NAN)}}),
                       "points: a coordinate is not finite"));
  EXPECT_TRUE(contains(refused({EditKind::kCut, {place}}), "`cut` needs two or more"));
  EXPECT_TRUE(contains(refused(cut(place, {{0, 0, 0}, {0, 0, 1}})),
                       "line: points 1 and 2 are the same in the direction of view"));
  EXPECT_TRUE(contains(refused(cut(place, {{0, 0, 0}, {1, 0, 0}}, Vec3::Zero())),
                       "view: (0, 0, 0) is no direction"));
}

}  // namespace
}  // namespace clast
