#include "classify/box_effect.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace clast {
namespace {

// s_c is 0.25 by the smallest box and 0.5 by the others: only these call the block elongated.
MeasuredBlock divided() {
  MeasuredBlock block = make_measured_block("divided", {1.25, 1.0, 0.9});
  block.axes_by_box = {{1.25, 1.0, 0.9}, {1.5, 1.0, 0.9}, {1.5, 1.0, 0.9}, {1.5, 1.0, 0.9}};
  return block;
}

MeasuredBlock agreed() {
  MeasuredBlock block = make_measured_block("agreed", {1.0, 1.0, 1.0});
  block.axes_by_box = {4, Axes{1.0, 1.0, 1.0}};
  return block;
}

TEST(BoxConventionEffect, CountsTheBlocksThatChangeTheirClass) {
  const std::vector<MeasuredBlock> blocks = {divided(), agreed(),
                                             make_measured_block("taped", {2.0, 1.0, 1.0})};
  const std::vector<std::string> schemes = {"garcia", "zingg"};
  const std::vector<BoxConventionEffect> effects = compare_box_conventions(blocks, schemes);
  ASSERT_EQ(effects.size(), 6u) << "the smallest box is in use";
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(effects[i].convention, kBoxConventions[1 + i % 3]);
    EXPECT_EQ(effects[i].scheme, schemes[i / 3]);
    EXPECT_EQ(effects[i].blocks, 2u) << "a row of a tape table has no boxes";
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(effects[i].reclassified, 1u);
  // I/L falls from 0.8 to 1/1.5, which is still the limit: spheroid by all boxes.
  for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(effects[i].reclassified, 0u);
  EXPECT_EQ(describe_box_convention_effect(effects[0]),
            "By the inertia box 1 of 2 blocks has another class of garcia.");
  EXPECT_EQ(describe_box_convention_effect(effects[3]),
            "By the inertia box none of 2 blocks has another class of zingg.");
}

// The class in use is the reference, whichever box it is from.
TEST(BoxConventionEffect, IsCountedFromTheAxesInUse) {
  MeasuredBlock block = divided();
  block.axes = block.axes_in_table_unit = block.axes_by_box[1];
  const std::vector<std::string> schemes = {"garcia"};
  const std::vector<BoxConventionEffect> effects =
      compare_box_conventions(std::span(&block, 1), schemes);
  ASSERT_EQ(effects.size(), 1u) << "the other three have the same axes";
  EXPECT_EQ(effects[0].convention, BoxConvention::kSmallest);
  EXPECT_EQ(effects[0].reclassified, 1u);
}

TEST(BoxConventionEffect, TapeTablesHaveNoneAndUnknownSchemesAreRefused) {
  const std::vector<MeasuredBlock> blocks = {make_measured_block("taped", {2.0, 1.0, 1.0})};
  const std::vector<std::string> schemes = {"garcia"}, unknown = {"roundish"};
  EXPECT_TRUE(compare_box_conventions(blocks, schemes).empty());
  const std::vector<MeasuredBlock> boxed = {divided()};
  EXPECT_THROW(compare_box_conventions(boxed, unknown), InputError);
}

}  // namespace
}  // namespace clast
