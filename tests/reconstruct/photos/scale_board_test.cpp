/// Boards: which lengths they give, which markers they leave out, what they refuse.
#include "reconstruct/photos/scale_board.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reconstruct/photos/photo_scale.hpp"
#include "tests/support/made_up_markers.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

constexpr double kBoardUnit = 0.37;  ///< m

/// Five markers on a plate of 0.8 x 0.5 m, in the frame of the plate.
ScaleBoard plate() {
  return {.dictionary = "4x4_50",
          .markers = {{0, {0.0, 0.0, 0.0}},
                      {1, {0.8, 0.0, 0.0}},
                      {2, {0.8, 0.5, 0.0}},
                      {3, {0.0, 0.5, 0.0}},
                      {7, {0.3, 0.2, 0.02}}}};
}

/// As photos see it: turned, moved and in units.
std::vector<LocatedMarker> seen(const ScaleBoard& board) {
  const Pose pose{{3.0, -2.0, 5.0}, Quat(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()))};
  std::vector<LocatedMarker> markers;
  for (const BoardMarker& marker : board.markers) {
    markers.push_back(
        made_up_marker(marker.id, pose * marker.centre / kBoardUnit, 0.1 / kBoardUnit));
  }
  return markers;
}

TEST(ScaleBoard, EveryDistanceOfTheBoardIsUsed) {
  const PhotoScale scale = estimate_scale_from_markers(seen(plate()), {.board = plate()});
  EXPECT_EQ(scale.measures.size(), 10u);
  EXPECT_NEAR(scale.metres_per_unit, kBoardUnit, 1e-12);
  EXPECT_TRUE(scale.from_bars);
  EXPECT_TRUE(scale.notes.empty());
  EXPECT_EQ(scale.measures[0].name, "markers 0 and 1");
  EXPECT_NEAR(scale.measures[0].length, 0.8, 1e-12);
}

TEST(ScaleBoard, AMarkerThatIsElsewhereIsNamedAndLeftOut) {
  for (std::size_t wrong = 0; wrong < 5; ++wrong) {
    ScaleBoard board = plate();
    board.markers[wrong].centre.y() += 0.012;
    const PhotoScale scale = estimate_scale_from_markers(seen(plate()), {.board = board});
    EXPECT_NEAR(scale.metres_per_unit, kBoardUnit, 1e-12) << wrong;
    EXPECT_EQ(scale.measures.size(), 6u);
    ASSERT_EQ(scale.notes.size(), 1u);
    EXPECT_TRUE(contains(scale.notes[0], "marker " + std::to_string(board.markers[wrong].id) +
                                             " is not at its position on the board"));
  }
}

TEST(ScaleBoard, TwoOfFiveAreLeftOutAndThreeThatDisagreeAreRefused) {
  ScaleBoard board = plate();
  board.markers[1].centre.x() += 0.02;
  board.markers[4].centre.y() += 0.03;
  const PhotoScale scale = estimate_scale_from_markers(seen(plate()), {.board = board});
  EXPECT_NEAR(scale.metres_per_unit, kBoardUnit, 1e-12);
  EXPECT_EQ(scale.notes.size(), 2u);

  ScaleBoard three = plate();
  three.markers.resize(3);
  const std::vector<LocatedMarker> found = seen(three);
  three.markers[0].centre.x() += 0.02;
  const std::string message =
      refusal([&] { estimate_scale_from_markers(found, {.board = three}); });
  EXPECT_TRUE(contains(message, "3 of its 3 points are too few to find which is wrong")) << message;
}

TEST(ScaleBoard, MarkersThatWereNotFoundAreNamed) {
  std::vector<LocatedMarker> markers = seen(plate());
  markers.erase(markers.begin() + 1, markers.begin() + 3);
  const PhotoScale scale = estimate_scale_from_markers(markers, {.board = plate()});
  EXPECT_NEAR(scale.metres_per_unit, kBoardUnit, 1e-12);
  EXPECT_TRUE(contains(scale.notes.at(0), "show marker 1, 2 of the board completely"));
  markers.resize(1);
  EXPECT_TRUE(contains(refusal([&] { estimate_scale_from_markers(markers, {.board = plate()}); }),
                       "no two of the board"));
}

TEST(ScaleBoard, SidesCheckTheBoardAndStandInForIt) {
  ScaleBoard board = plate();
  board.marker_side = 0.102;
  const PhotoScale both = estimate_scale_from_markers(seen(plate()), {.board = board});
  ASSERT_TRUE(both.marker_side_ratio.has_value());
  EXPECT_NEAR(*both.marker_side_ratio, 0.1 / 0.102 - 1.0, 1e-12);
  EXPECT_TRUE(contains(both.notes.at(0), "shorter than given"));
  std::vector<LocatedMarker> one = seen(plate());
  one.resize(1);
  board.marker_side = 0.1;
  const PhotoScale side = estimate_scale_from_markers(one, {.board = board});
  EXPECT_FALSE(side.from_bars);
  EXPECT_NEAR(side.metres_per_unit, kBoardUnit, 1e-12);
}

/// Corners as found, in units.
std::vector<BoardCorner> corners(const CharucoBoard& board, double noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<BoardCorner> found;
  for (int k = 0; k < (board.columns - 1) * (board.rows - 1); ++k) {
    const Vec3 position =
        board.square * Vec3(k % (board.columns - 1), k / (board.columns - 1), 0.0);
    found.push_back({k, (position + noise * random.unit_vector()) / kBoardUnit, 8, 0.1});
  }
  return found;
}

TEST(ScaleBoard, RowsAndColumnsOfAChArUcoBoardGiveTheScale) {
  const CharucoBoard board{"5x5_100", 7, 5, 0.04, 0.03, false};
  std::vector<BoardCorner> found = corners(board, 2e-5, 3);
  const ScaleOptions options{.board = ScaleBoard{.dictionary = "5x5_100", .charuco = board}};
  const PhotoScale scale = estimate_scale_from_markers({}, options, found);
  EXPECT_EQ(scale.measures.size(), 4u + 6u);
  // Ends of rows are off by 2e-5 m each, over 0.12 to 0.20 m.
  EXPECT_NEAR(scale.metres_per_unit / kBoardUnit, 1.0, 1.5e-4);
  EXPECT_EQ(scale.measures[0].name, "row 1 of the board, corner 0 to corner 5");

  found[8].position.x() += 0.01;
  const PhotoScale without = estimate_scale_from_markers({}, options, found);
  EXPECT_TRUE(contains(without.notes.at(0), "corner 8 is not at its position on the board"));
  EXPECT_NEAR(without.metres_per_unit / kBoardUnit, 1.0, 1.5e-4);
  found.resize(1);
  EXPECT_TRUE(contains(refusal([&] { estimate_scale_from_markers({}, options, found); }),
                       "1 of its corners"));
}

TEST(ScaleBoard, WhatIsNoBoardIsRefused) {
  const auto refused = [](const ScaleBoard& board) {
    return refusal([&] { estimate_scale_from_markers({}, {.board = board}); });
  };
  ScaleBoard board = plate();
  board.markers.resize(1);
  EXPECT_TRUE(contains(refused(board), "1 markers; at least two"));
  board = plate();
  board.markers[3].id = 1;
  EXPECT_TRUE(contains(refused(board), "marker 1 is given twice"));
  board = plate();
  board.markers[3].centre = board.markers[0].centre;
  EXPECT_TRUE(contains(refused(board), "markers 0 and 3 are 0 m apart"));
  board = plate();
  board.dictionary = "6x7";
  EXPECT_TRUE(contains(refused(board), "\"6x7\" isn't known"));
  board.dictionary = "auto";
  EXPECT_TRUE(contains(refused(board), "name that of the board"));
  board = plate();
  board.charuco = CharucoBoard{"5x5_100", 7, 5, 0.04, 0.03, false};
  EXPECT_TRUE(contains(refused(board), "give only one of them"));
  const auto charuco = [&](CharucoBoard one) {
    return refused({.dictionary = "5x5_100", .charuco = one});
  };
  EXPECT_TRUE(contains(charuco({"5x5_100", 2, 5, 0.04, 0.03, false}), "2 x 5 squares"));
  EXPECT_TRUE(
      contains(charuco({"5x5_100", 7, 5, 0.0, 0.03, false}), "can't be the side of a square"));
  EXPECT_TRUE(contains(charuco({"5x5_100", 7, 5, 0.04, 0.05, false}), "don't fit"));
  EXPECT_TRUE(contains(charuco({"4x4_50", 11, 11, 0.04, 0.03, false}), "has 50"));
}

}  // namespace
}  // namespace clast
