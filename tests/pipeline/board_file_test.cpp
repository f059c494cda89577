// The file of a board with markers: what is refused, with file, line and key.
#include "pipeline/board_file.hpp"

#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(BoardFile, WhatIsNoBoardIsRefusedWithItsPlace) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& board) {
    write_text_file(folder / "board.toml", board);
    return refusal([&] { read_scale_board(folder / "board.toml"); });
  };
  const std::string head = "dictionary = \"4x4_50\"\n";
  const std::string markers =
      "[[marker]]\nid = 0\ncentre_m = [0, 0]\n[[marker]]\nid = 1\ncentre_m = [0.6, 0, 0.1]\n";
  const std::string charuco =
      "[charuco]\ncolumns = 7\nrows = 5\nsquare_m = 0.04\nmarker_m = 0.03\n";
  write_text_file(folder / "good.toml", head + markers);
  EXPECT_FALSE(read_scale_board(folder / "good.toml").charuco);
  EXPECT_TRUE(contains(refused(head), "board.toml: board: 0 markers"));
  EXPECT_TRUE(contains(refused(markers), "dictionary"));
  EXPECT_TRUE(contains(refused(head + markers + charuco), "give only one of them"));
  EXPECT_TRUE(contains(refused(head + "side_m = 0.1\n" + markers), "board.toml:2"));
  EXPECT_TRUE(contains(refused(head + "[[marker]]\nid = 0\ncentre_m = [0]\n"), "board.toml:4"));
  EXPECT_TRUE(contains(refused(head + "[marker]\nid = 0\n"), "[[marker]]"));
  EXPECT_TRUE(contains(refused(head + "[charuco]\ncolumns = 7\n"), "rows"));
  EXPECT_TRUE(contains(refused("dictionary = \"5x7\"\n" + markers), "\"5x7\" isn't known"));
  EXPECT_TRUE(contains(refusal([&] { read_scale_board(folder / "none.toml"); }), "none.toml"));
}

}  // namespace
}  // namespace clast
