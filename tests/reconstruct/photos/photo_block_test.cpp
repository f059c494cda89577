/// From the photos of the rendered rock and their stored cameras to a block, against its truth.
#include <gtest/gtest.h>

#include <iostream>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "shapes/mesh_io.hpp"
#include "shapes/mesh_topology.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::filesystem::path rock(const std::string& name) {
  return test_data("photos/synthetic_rock/" + name);
}

TEST(PhotoBlock, AxesAndVolumeOfTheRock) {
  PhotoScanOptions options{.model = rock("colmap_txt")};
  options.scale.marker_side = 0.2;
  const PhotoScan scan = photo_scan(rock("images"), options);
  EXPECT_TRUE(scan.metric);
  ASSERT_EQ(scan.markers.markers.size(), 4u);
  FieldScanOptions reading;
  reading.surface.cell = 0.003;
  reading.through = &scan.cloud.through;
  const FieldBlock block = field_blocks(scan.cloud.points, "rock", reading).front();
  EXPECT_TRUE(inspect(block.scan.mesh).closed());
  const TriangleMesh truth = read_mesh(rock("gt_rock.ply"));
  const double volume = 0.137;  // the set's own statement, m^3
  const Vec3 sides = smallest_box(block.scan.mesh.vertices).lengths;
  const Vec3 errors = sides.cwiseQuotient(smallest_box(truth.vertices).lengths) - Vec3::Ones();
  ASSERT_TRUE(block.underside.has_value());
  std::cout << "L, I, S " << 100.0 * errors.transpose() << " %, volume "
            << block.underside->lower_volume << " " << block.underside->best_volume << " "
            << block.underside->upper_volume << " of " << volume << "\n";
  // The rock is undercut all round its foot, which no photo shows: I and S rest on the filling.
  for (int axis = 0; axis < 3; ++axis) EXPECT_LT(std::abs(errors[axis]), 0.005) << axis;
  EXPECT_LE(block.underside->lower_volume, volume);
  EXPECT_GE(block.underside->upper_volume, volume);
  // 1.21 times the volume without what the photos looked through.
  EXPECT_LE(block.underside->upper_volume, 1.16 * volume);
}

TEST(PhotoBlock, WithoutAScaleItIsRefusedUnlessThatIsAllowed) {
  const std::string text =
      refusal([&] { photo_scan(rock("images"), {.model = rock("colmap_txt")}); });
  EXPECT_TRUE(contains(text, "no scale"));
  EXPECT_TRUE(contains(text, "--scale-bar"));
  EXPECT_TRUE(contains(text, "masses are not"));
}

}  // namespace
}  // namespace clast
