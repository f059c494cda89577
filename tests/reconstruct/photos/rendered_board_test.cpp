/// Scales from boards and tags that OpenCV draws and photos are rendered of: within 0.05 %.
#include "tests/reconstruct/photos/rendered_board.hpp"

#include <gtest/gtest.h>

#include "reconstruct/photos/photo_scale.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

constexpr double kUnit = 0.3717;  ///< m of a unit of the model
constexpr double kBar = 0.0005;

double error_of(const PhotoScale& scale) { return scale.metres_per_unit / kUnit - 1.0; }

TEST(RenderedBoard, AChArUcoBoardGivesTheScale) {
  const ScratchFolder folder;
  const CharucoBoard board{"5x5_100", 7, 5, 0.04, 0.03, false};
  const PhotoModel model = photographed(drawn_board(board), kUnit, folder);
  const std::vector<BoardCorner> corners = find_board_corners(model, board, {.threads = 2});
  ASSERT_EQ(corners.size(), 24u);
  double worst = 0.0;
  std::size_t fewest = model.photos.size();
  for (const BoardCorner& corner : corners) {
    worst = std::max(worst, corner.error);
    fewest = std::min(fewest, corner.photos);
  }
  const PhotoScale scale = estimate_scale_from_markers(
      {}, {.board = ScaleBoard{.dictionary = "5x5_100", .charuco = board}}, corners);
  std::cout << "ChArUco: " << 100.0 * error_of(scale) << " %, spread " << 100.0 * scale.spread
            << " %, corners up to " << worst << " px, in " << fewest << " photos or more\n";
  EXPECT_LT(std::abs(error_of(scale)), kBar);
  EXPECT_LT(worst, 0.5);
  EXPECT_GE(fewest, 5u);
  EXPECT_TRUE(scale.notes.empty());

  CharucoBoard other = board;
  other.dictionary = "4x4_50";
  EXPECT_TRUE(find_board_corners(model, other, {.threads = 2}).empty());
  const std::vector<BoardCorner> again = find_board_corners(model, board, {.threads = 1});
  for (std::size_t i = 0; i < corners.size(); ++i)
    EXPECT_EQ(again[i].position, corners[i].position);
}

TEST(RenderedBoard, AnEvenNumberOfRowsIsTheSameToIt) {
  const ScratchFolder folder;
  const CharucoBoard board{"5x5_100", 6, 4, 0.04, 0.03, false};
  const PhotoModel model = photographed(drawn_board(board), kUnit, folder);
  const std::vector<BoardCorner> corners = find_board_corners(model, board, {.threads = 2});
  ASSERT_EQ(corners.size(), 15u);
  const PhotoScale scale = estimate_scale_from_markers(
      {}, {.board = ScaleBoard{.dictionary = "5x5_100", .charuco = board}}, corners);
  std::cout << "ChArUco, even: " << 100.0 * error_of(scale) << " %\n";
  EXPECT_LT(std::abs(error_of(scale)), kBar);
  EXPECT_TRUE(scale.notes.empty());
}

#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR < 408
TEST(RenderedBoard, TheOlderPatternNeedsANewerOpenCv) {
  const CharucoBoard board{"5x5_100", 7, 4, 0.04, 0.03, true};
  EXPECT_TRUE(contains(refusal([&] { board.check(); }), "older_pattern = false"));
  CharucoBoard odd = board;
  odd.rows = 5;
  EXPECT_NO_THROW(odd.check());
}
#endif

class Tags : public testing::TestWithParam<const char*> {};

TEST_P(Tags, OnAPlateGiveTheScaleByTheirCentresAndTheirSides) {
  const ScratchFolder folder;
  const double side = 0.06;
  const std::vector<Vec2> centres = {{0.07, 0.06}, {0.33, 0.07}, {0.32, 0.24}, {0.08, 0.23}};
  const PhotoModel model =
      photographed(drawn_markers(GetParam(), side, centres, 0.40, 0.30), kUnit, folder);
  const MarkerSearchResult search = search_markers(model, {.dictionary = GetParam(), .threads = 2});
  ASSERT_EQ(search.markers.size(), 4u);
  EXPECT_TRUE(search.unlocated.empty());
  EXPECT_EQ(search.dictionary, GetParam());
  ScaleBoard board{.dictionary = GetParam()};
  for (int id = 0; id < 4; ++id) {
    const Vec2& at = centres[static_cast<std::size_t>(id)];
    board.markers.push_back({id, {at.x(), at.y(), 0.0}});
  }
  const PhotoScale by_board = estimate_scale_from_markers(search.markers, {.board = board});
  const PhotoScale by_side = estimate_scale_from_markers(search.markers, {.marker_side = side});
  std::cout << GetParam() << ": centres " << 100.0 * error_of(by_board) << " %, sides "
            << 100.0 * error_of(by_side) << " %\n";
  EXPECT_LT(std::abs(error_of(by_board)), kBar);
  EXPECT_LT(std::abs(error_of(by_side)), 2.0 * kBar);

  board.markers[2].centre.x() += 0.004;
  const PhotoScale mended = estimate_scale_from_markers(search.markers, {.board = board});
  EXPECT_LT(std::abs(error_of(mended)), kBar);
  EXPECT_TRUE(contains(mended.notes.at(0), "marker 2 is not at its position on the board"));
}

INSTANTIATE_TEST_SUITE_P(Families, Tags, testing::Values("apriltag_36h11", "4x4_50"));

}  // namespace
}  // namespace clast
