// Passes inside one scan that do not fit: found, reported and aligned.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reconstruct/joined_scan.hpp"
#include "reconstruct/registration/passes.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/sampled_cloud.hpp"
#include "tests/support/strips.hpp"

namespace clast {
namespace {

TriangleMesh striped_rock() { return rock_mesh(16, {0.5, 0.4, 0.3}, 6); }

StripScan displaced_strips(std::uint64_t seed, double shift, std::size_t passes = 2) {
  Random random(seed);
  StripRecipe recipe;
  recipe.passes = passes;
  recipe.shift = shift;
  recipe.rotation = 0.3 * kPi / 180.0;
  recipe.overlap = 0.8;
  return make_strips(striped_rock(), recipe, random);
}

TEST(Passes, AMisfitIsFoundWithItsShift) {
  for (const double shift : {0.01, 0.02, 0.03}) {
    const StripScan scan = displaced_strips(4, shift);
    const std::optional<PassMisfit> misfit = find_pass_misfit(scan.points);
    ASSERT_TRUE(misfit) << shift;
    // A smooth rock hardly distinguishes movements along its surface from rotations.
    EXPECT_GT(misfit->shift.norm(), 0.3 * shift * scan.size);
    EXPECT_LT(misfit->shift.norm(), 1.6 * shift * scan.size);
    EXPECT_GT(misfit->fraction, 0.02);
    EXPECT_GT(misfit->explained, 0.5);
  }
}

TEST(Passes, ThatFitAreNotReported) {
  for (const double noise : {0.0, 0.001, 0.003, 0.005}) {
    const std::vector<Vec3> points =
        sampled_cloud(striped_rock(), {.points = 12000, .noise = noise}, 3);
    EXPECT_FALSE(find_pass_misfit(points)) << noise;
  }
  EXPECT_FALSE(find_pass_misfit(displaced_strips(5, 0.0).points));
}

TEST(Passes, AreTheSourcesOrThePartsBetweenPauses) {
  EXPECT_TRUE(number_passes(std::vector<PointRecording>{{7, 0.0}, {7, 1.0}}).empty());
  EXPECT_EQ(number_passes(std::vector<PointRecording>{{9, 0.0}, {7, 0.0}, {9, 0.0}}),
            (std::vector<std::uint32_t>{1, 0, 1}));
  EXPECT_EQ(number_passes(std::vector<PointRecording>{{7, 100.0}, {7, 0.0}, {7, 5.0}}),
            (std::vector<std::uint32_t>{1, 0, 0}));
}

TEST(Passes, OfAScanOfOnePassAreNotAligned) {
  FieldScanOptions options;
  options.find_ground = false;
  EXPECT_FALSE(align_passes({"rock", {displaced_strips(5, 0.0).points, {}}, {}}, {}, "B", options,
                            {.threads = 1}));
}

/// Volume of aligned strips relative to that of the rock.
double aligned_volume(const StripScan& strips, bool with_passes, std::string& notes) {
  FieldScanOptions options;
  options.find_ground = false;
  const std::optional<JoinedScan> aligned = align_passes(
      {"rock", {strips.points, {}}, {}}, with_passes ? strips.passes : std::vector<std::uint32_t>{},
      "B", options, {.threads = 0});
  if (!aligned) return 0.0;
  for (const std::string& note : aligned->block.scan.notes) notes += note + "\n";
  return signed_volume(aligned->block.scan.mesh) / signed_volume(striped_rock());
}

TEST(Passes, OfKnownSourcesAreAlignedToTheVolumeOfTheBlock) {
  std::string notes;
  EXPECT_NEAR(aligned_volume(displaced_strips(8, 0.02, 3), true, notes), 1.0, 0.01);
  EXPECT_TRUE(contains(notes, "joined from 3 passes of rock")) << notes;
  EXPECT_TRUE(contains(notes, "pass 2 was moved by ")) << notes;
}

TEST(Passes, OfUnknownSourcesAreAlignedToTheVolumeOfTheBlock) {
  std::string notes;
  EXPECT_NEAR(aligned_volume(displaced_strips(4, 0.02), false, notes), 1.0, 0.01);
  EXPECT_TRUE(contains(notes, "joined from 2 passes of rock")) << notes;
}

TEST(Passes, ThatDoNotFitAreReportedWithWiderBounds) {
  const StripScan strips = displaced_strips(4, 0.02);
  FieldScanOptions options;
  options.find_ground = false;
  try {
    const FieldBlock block = extract_field_blocks(strips.points, "rock", options)[0];
    ASSERT_FALSE(block.scan.notes.empty());
    EXPECT_TRUE(contains(block.scan.notes[0], "its passes do not fit")) << block.scan.notes[0];
    ASSERT_TRUE(block.bounds);
    const double truth = signed_volume(striped_rock());
    EXPECT_LT(block.bounds->lower_volume, truth);
    EXPECT_GT(block.bounds->upper_volume.value_or(1e300), truth);
  } catch (const Error& error) {
    EXPECT_TRUE(contains(error.what(), "its passes do not fit")) << error.what();
  }
}

}  // namespace
}  // namespace clast
