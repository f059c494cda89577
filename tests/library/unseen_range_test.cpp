#include "library/unseen_range.hpp"

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
  block.unseen = {.lower_volume = 0.9,
                  .best_volume = 1.0,
                  .upper_volume = 1.2,
                  .invented_share = 0.17,
                  .lower_axes = {2.0, 1.0, 0.5},
                  .upper_axes = {2.0, 1.0, 0.8}};
  return block;
}

TEST(UnseenRange, MassFollowsTheVolumeAtTheGivenDensity) {
  const UnseenRange range = unseen_range(half_seen());
  EXPECT_DOUBLE_EQ(range.lower_mass, 2250.0);
  EXPECT_DOUBLE_EQ(range.upper_mass, 3000.0);
  EXPECT_DOUBLE_EQ(range.lower_density, 2500.0);
  EXPECT_DOUBLE_EQ(range.upper_density, 2500.0);
}

TEST(UnseenRange, OfAWeighedBlockTheDensityIsOpenAndNotTheMass) {
  Block block = half_seen();
  block.field.weighed_mass = 2500.0;
  const UnseenRange range = unseen_range(block);
  EXPECT_DOUBLE_EQ(range.lower_mass, 2500.0);
  EXPECT_DOUBLE_EQ(range.upper_mass, 2500.0);
  EXPECT_DOUBLE_EQ(range.lower_density, 2500.0 / 1.2);
  EXPECT_DOUBLE_EQ(range.upper_density, 2500.0 / 0.9);
}

TEST(UnseenRange, ClassesAreThoseFromTheLowerToTheUpperBox) {
  const UnseenRange range = unseen_range(half_seen());
  // Zingg: I/L is 1/2, below 2/3; S/I passes 2/3 on the way from 0.5 to 0.8.
  EXPECT_EQ(range.classes.at("zingg"),
            (std::vector<std::string>{zingg_class({2.0, 1.0, 0.5}), zingg_class({2.0, 1.0, 0.8})}));
  EXPECT_NE(range.classes.at("zingg")[0], range.classes.at("zingg")[1]);
  EXPECT_EQ(range.classes.at("garcia").size(), 1u);
  EXPECT_DOUBLE_EQ(range.lower_s_c, 1.0);
  EXPECT_DOUBLE_EQ(range.upper_s_c, 1.0);
}

TEST(UnseenRange, ElongationCoversTheBlockAndBothBoxes) {
  Block block = half_seen();
  block.unseen->lower_axes = {2.0, 0.8, 0.6};
  block.unseen->upper_axes = {2.1, 1.2, 0.6};
  const UnseenRange range = unseen_range(block);
  EXPECT_NEAR(range.lower_s_c, 2.1 / 1.2 - 1.0, 1e-12);
  EXPECT_NEAR(range.upper_s_c, 2.0 / 0.8 - 1.0, 1e-12);
}

TEST(UnseenRange, IsToldInWords) {
  const Block block = half_seen();
  EXPECT_EQ(described_unseen(block),
            "the scan was open: 17 % of the surface is not seen but filled in; volume between 0.9 "
            "and 1.2 m3 (best 1), mass between 2250 and 3000 kg");
  Block unscaled = block;
  unscaled.source.unscaled = true;
  EXPECT_EQ(described_unseen(unscaled),
            "the scan was open: 17 % of the surface is not seen but filled in; volume between 0.9 "
            "and 1.2 cubic model units (best 1)");
}

TEST(UnseenRange, ThatMattersToNobodyIsToldAsSuch) {
  Block block = half_seen();
  block.unseen->invented_share = 5e-4;
  block.unseen->lower_volume = block.unseen->upper_volume = block.unseen->best_volume;
  EXPECT_EQ(described_unseen(block),
            "the scan was open, but hardly: 0.05 % of the surface is not seen but filled in, which "
            "leaves volume and mass open by less than 0.1 %");
}

}  // namespace
}  // namespace clast
