#include "library/block_bracket.hpp"

#include <gtest/gtest.h>

#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// A block of 2 x 1 x 0.6 m whose unseen side leaves S between 0.5 and 0.8 m.
Block half_seen() {
  Block block = filled_block("B1");
  block.density = 2500.0;
  block.mass.volume = 1.0;
  block.mass.mass = 2500.0;
  block.field.weighed_mass.reset();
  block.box.lengths = {2.0, 1.0, 0.6};
  block.volume_bracket = VolumeBracket{.lower_volume = 0.9,
                                       .estimated_volume = 1.0,
                                       .upper_volume = 1.2,
                                       .sides = BoxSideBounds{{2.0, 1.0, 0.5}, {2.0, 1.0, 0.8}},
                                       .filled_fraction = 0.17,
                                       .assumption = "the flanks go on"};
  return block;
}

TEST(BlockBracket, MassFollowsTheVolumeAtTheGivenDensity) {
  const BlockBracket range = derive_block_bracket(half_seen());
  EXPECT_DOUBLE_EQ(range.lower_mass, 2250.0);
  EXPECT_DOUBLE_EQ(range.upper_mass.value(), 3000.0);
  EXPECT_DOUBLE_EQ(range.lower_density.value(), 2500.0);
  EXPECT_DOUBLE_EQ(range.upper_density, 2500.0);
}

TEST(BlockBracket, OfAWeighedBlockTheDensityIsOpenAndNotTheMass) {
  Block block = half_seen();
  block.field.weighed_mass = 2500.0;
  const BlockBracket range = derive_block_bracket(block);
  EXPECT_DOUBLE_EQ(range.lower_mass, 2500.0);
  EXPECT_DOUBLE_EQ(range.upper_mass.value(), 2500.0);
  EXPECT_DOUBLE_EQ(range.lower_density.value(), 2500.0 / 1.2);
  EXPECT_DOUBLE_EQ(range.upper_density, 2500.0 / 0.9);
}

TEST(BlockBracket, ClassesAreAllThatTheAxesAllow) {
  const BlockBracket range = derive_block_bracket(half_seen());
  // Zingg: I/L is 1/2, below 2/3; S/I passes 2/3 on the way from 0.5 to 0.8.
  EXPECT_EQ(range.classes.at("zingg"), (std::vector<std::string>{"blade", "rod"}));
  EXPECT_EQ(range.classes.at("garcia"), (std::vector<std::string>{"elongated"}));
  EXPECT_DOUBLE_EQ(range.lower_s_c.value(), 1.0);
  EXPECT_DOUBLE_EQ(range.upper_s_c.value(), 1.0);
}

TEST(BlockBracket, ClassesOfABlockOfADepositAreThoseOfItsIntervals) {
  Block block = half_seen();
  block.volume_bracket->intervals = {0.95, 1.1, {{2.0, 1.0, 0.55}, {2.0, 1.0, 0.65}}};
  const BlockBracket range = derive_block_bracket(block);
  // S/I does not pass 2/3 within the interval of S.
  EXPECT_EQ(range.classes.at("zingg"), (std::vector<std::string>{"blade"}));
  EXPECT_DOUBLE_EQ(range.axes->upper.S, 0.8);
}

// Between boxes of 1.4 x 1.2 and of 1.6 x 1.4 L/I is 1.17 and 1.14 alone; a body of 1.6 x 1.2 has
// 1.33, which is elongated.
TEST(BlockBracket, AxesRunThroughTheirBoundsEachByItself) {
  Block block = half_seen();
  block.box.lengths = {1.5, 1.3, 1.0};
  block.volume_bracket->sides = BoxSideBounds{{1.4, 1.2, 1.0}, {1.6, 1.4, 1.0}};
  const BlockBracket range = derive_block_bracket(block);
  EXPECT_EQ(range.classes.at("garcia"), (std::vector<std::string>{"compact", "elongated"}));
  EXPECT_NEAR(range.lower_s_c.value(), 0.0, 1e-12);  // 1.4 / 1.4
  EXPECT_NEAR(range.upper_s_c.value(), 1.6 / 1.2 - 1.0, 1e-12);
}

TEST(BlockBracket, TheBlocksOwnAxesAreWithinTheBounds) {
  Block block = half_seen();
  block.volume_bracket->sides = BoxSideBounds{{2.05, 0.8, 0.65}, {2.1, 0.9, 0.7}};
  const BlockBracket range = derive_block_bracket(block);
  EXPECT_EQ(range.axes->lower.L, 2.0);
  EXPECT_EQ(range.axes->upper.I, 1.0);
  EXPECT_EQ(range.axes->lower.S, 0.6);
}

/// The same block of which too much is not seen.
Block hardly_seen() {
  Block block = half_seen();
  block.volume_bracket->upper_volume.reset();
  block.volume_bracket->sides.reset();
  return block;
}

TEST(BlockBracket, WithoutUpperVolumeNothingIsBoundFromAbove) {
  const BlockBracket range = derive_block_bracket(hardly_seen());
  EXPECT_DOUBLE_EQ(range.lower_mass, 2250.0);
  EXPECT_FALSE(range.upper_mass.has_value());
  EXPECT_FALSE(range.axes.has_value());
  EXPECT_FALSE(range.upper_s_c.has_value());
  EXPECT_TRUE(range.classes.empty());
  Block weighed = hardly_seen();
  weighed.field.weighed_mass = 2500.0;
  const BlockBracket of_weighed = derive_block_bracket(weighed);
  EXPECT_DOUBLE_EQ(of_weighed.upper_mass.value(), 2500.0);
  EXPECT_FALSE(of_weighed.lower_density.has_value());
  EXPECT_DOUBLE_EQ(of_weighed.upper_density, 2500.0 / 0.9);
}

TEST(BlockBracket, SaysThatNoUpperBoundCanBeGiven) {
  EXPECT_EQ(describe_volume_bracket(hardly_seen()),
            "the scan was open: 17 % of the surface was not scanned but filled in; too much of the "
            "block for an upper bound: volume at least 0.9 m3 (best 1), mass at least 2250 "
            "kg; no upper bound can be given: scan more of the block");
}

TEST(BlockBracket, IsToldInWords) {
  const Block block = half_seen();
  EXPECT_EQ(
      describe_volume_bracket(block),
      "the scan was open: 17 % of the surface was not scanned but filled in; volume between 0.9 "
      "and 1.2 m3 (best 1), mass between 2250 and 3000 kg");
  Block unscaled = block;
  unscaled.source.unscaled = true;
  EXPECT_EQ(
      describe_volume_bracket(unscaled),
      "the scan was open: 17 % of the surface was not scanned but filled in; volume between 0.9 "
      "and 1.2 cubic model units (best 1)");
}

TEST(BlockBracket, OfAScanThatWasNotOpenSaysSo) {
  Block block = half_seen();
  block.volume_bracket->filled_fraction =
      0.0;  // points that lie apart, or two copies of the surface
  EXPECT_EQ(
      describe_volume_bracket(block),
      "the surface is not known exactly; volume between 0.9 and 1.2 m3 (best 1), mass between "
      "2250 and 3000 kg");
}

TEST(BlockBracket, ThatMattersToNobodyIsToldAsSuch) {
  Block block = half_seen();
  block.volume_bracket->filled_fraction = 5e-4;
  block.volume_bracket->lower_volume = block.volume_bracket->estimated_volume;
  block.volume_bracket->upper_volume = block.volume_bracket->estimated_volume;
  EXPECT_EQ(describe_volume_bracket(block),
            "the scan was only slightly open: 0.05 % of the surface was not scanned but filled in, "
            "which leaves volume and mass uncertain by less than 0.1 %");
}

}  // namespace
}  // namespace clast
