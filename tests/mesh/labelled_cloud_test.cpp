#include "mesh/labelled_cloud.hpp"

#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "mesh/point_cloud.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(LabelledCloud, IsReadAsItWasWritten) {
  const ScratchFolder folder;
  const std::vector<Vec3> points = {{0.5, -1.25, 3.0}, {1.0, 2.0, -4.5}};
  const std::vector<std::uint32_t> blocks = {0, 70000};
  write_labelled_cloud(folder / "truth.ply", points, blocks);
  const LabelledCloud read = read_labelled_cloud(folder / "truth.ply");
  EXPECT_EQ(read.points, points);
  EXPECT_EQ(read.blocks, blocks);
}

TEST(LabelledCloud, MapCoordinatesLoseNoDigits) {
  const ScratchFolder folder;
  const std::vector<Vec3> points = {{652013.123, 5203000.456, 1824.1}};
  write_labelled_cloud(folder / "map.ply", points, std::vector<std::uint32_t>{3});
  EXPECT_EQ(read_labelled_cloud(folder / "map.ply").points, points);
}

TEST(LabelledCloud, OthersReadThePoints) {
  const ScratchFolder folder;
  const std::vector<Vec3> points = {{0.5, -1.25, 3.0}, {1.0, 2.0, -4.5}};
  write_labelled_cloud(folder / "scan.ply", points, {});
  EXPECT_EQ(read_cloud(folder / "scan.ply"), points);
  EXPECT_TRUE(contains(refusal([&] { read_labelled_cloud(folder / "scan.ply"); }),
                       "no property \"block\""));
}

TEST(LabelledCloud, BlocksAreWholeNumbers) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& block) {
    write_text_file(folder / "a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float block\n"
                    "property float x\nproperty float y\nproperty float z\nend_header\n" +
                        block + " 1 2 3\n");
    return refusal([&] { read_labelled_cloud(folder / "a.ply"); });
  };
  EXPECT_EQ(refused("4"), "");
  EXPECT_TRUE(contains(refused("4.5"), "point 1 has the block 4.5"));
  EXPECT_TRUE(contains(refused("-1"), "point 1 has the block -1"));
}

}  // namespace
}  // namespace clast
