#include "classify/population_notes.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusal.hpp"

namespace clast {
namespace {

MeasuredBlock block(const std::string& name, double error) {
  MeasuredBlock one = make_measured_block(name, {0.03, 0.02, 0.01});
  one.axis_error = error;
  return one;
}

TEST(PopulationNotes, NothingIsSaidOfBlocksThatAreFine) {
  EXPECT_TRUE(population_notes({}).empty());
  EXPECT_TRUE(population_notes(std::vector{block("A", 0.001), block("B", 0.0)}).empty());
}

TEST(PopulationNotes, NamesThatStandTwiceAreCounted) {
  const auto notes = population_notes(
      std::vector{block("B", 0), block("A", 0), block("B", 0), block("C", 0), block("B", 0)});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(contains(notes[0], "each of them is counted: B 3 times"));
  std::vector<MeasuredBlock> many;
  for (int i = 0; i < 16; ++i) many.push_back(block("N" + std::to_string(i / 2), 0));
  EXPECT_TRUE(contains(population_notes(many).at(0), "N4 2 times and 3 more"));
}

TEST(PopulationNotes, UnscaledBlocksAreNamed) {
  std::vector<MeasuredBlock> blocks;
  for (int i = 0; i < 8; ++i) {
    blocks.push_back(block("B" + std::to_string(i), 0.0));
    blocks.back().unscaled = i > 0;
  }
  const auto notes = population_notes(blocks);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(contains(notes[0], "not in sizes and masses: B1, B2, B3, B4, B5 and 2 more;"));
}

// Pebbles of 20 mm with the error of a tape.
TEST(PopulationNotes, AnErrorAsLargeAsTheAxesIsSaid) {
  const auto notes =
      population_notes(std::vector{block("A", 0.05), block("B", 0.01), block("C", 0.0099)});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(contains(notes[0], "2 of 3 blocks") && contains(notes[0], "0.05 m") &&
              contains(notes[0], "`axis_error`"));
}

}  // namespace
}  // namespace clast
