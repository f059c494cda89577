/// From the photos of the rendered rock and their stored cameras to a block, against its truth.
#include <gtest/gtest.h>

#include <array>

#include "mesh/mesh_topology.hpp"
#include "tests/reconstruct/photos/rock_block.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::filesystem::path rock_file(const std::string& name) {
  return test_data("photos/synthetic_rock/" + name);
}

TEST(PhotoBlock, AxesAndVolumeOfTheRock) {
  PhotoScanOptions options{.model = rock_file("colmap_txt")};
  options.scale.marker_side = 0.2;
  const PhotoScan scan = reconstruct_from_photos(rock_file("images"), options);
  EXPECT_TRUE(scan.metric);
  ASSERT_EQ(scan.markers.markers.size(), 4u);
  const RockBlock rock_block(scan);
  EXPECT_TRUE(inspect_mesh(rock_block.block.scan.mesh).is_closed());
  // I rests on the filling; see docs/accuracy.md for how it moves.
  // I and S rest on the filling too: -0.59 and -0.61 %. Since the surface ends at the last points,
  // and not 1.5 cells beyond them, the filling starts higher (-0.42 and +0.21 % before).
  const std::array<double, 3> bars = {0.005, 0.007, 0.007};
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LT(std::abs(rock_block.sides[axis]), bars[static_cast<std::size_t>(axis)]) << axis;
  }
  for (const int axis : {0, 2}) EXPECT_LT(std::abs(rock_block.extents[axis]), 0.005) << axis;
  const Underside& underside = *rock_block.block.underside;
  EXPECT_LE(underside.lower_volume, rock_block.true_volume);
  EXPECT_GE(underside.upper_volume.value(), rock_block.true_volume);
  // 1.21 times the volume without what the photos looked through.
  EXPECT_LE(underside.upper_volume.value(), 1.16 * rock_block.true_volume);
}

TEST(PhotoBlock, WithoutAScaleItIsRefusedUnlessThatIsAllowed) {
  const std::string text = refusal(
      [&] { reconstruct_from_photos(rock_file("images"), {.model = rock_file("colmap_txt")}); });
  EXPECT_TRUE(contains(text, "no scale"));
  EXPECT_TRUE(contains(text, "`bars`"));
  EXPECT_TRUE(contains(text, "masses are unknown"));
}

}  // namespace
}  // namespace clast
