/// Seats of made-up cameras.
#include "reconstruct/photos/camera_ring.hpp"
#include "core/angle.hpp"

#include <gtest/gtest.h>

namespace clast {
namespace {

TEST(CameraRing, SeatsAndTheLargestGapAreThoseTheCamerasWerePutAt) {
  PhotoScan scan;
  scan.cloud.region.centre = {1.0, 2.0, 3.0};
  // Every 30 degrees, 20 degrees up and 2 m away, but none from 120 to 240.
  const Pose block_from_model{Vec3(0.5, 0.0, -1.0),
                              Quat(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()))};
  const Vec3 middle = block_from_model * scan.cloud.region.centre;
  for (const double azimuth : {0.0, 30.0, 60.0, 90.0, 120.0, -120.0, -90.0, -60.0, -30.0}) {
    const Vec3 out(std::cos(20.0 * kRadiansPerDegree) * std::cos(azimuth * kRadiansPerDegree),
                   std::cos(20.0 * kRadiansPerDegree) * std::sin(azimuth * kRadiansPerDegree),
                   std::sin(20.0 * kRadiansPerDegree));
    const Vec3 centre = block_from_model.inverse() * (middle + 2.0 * out);
    scan.model.photos.push_back({"p", {}, 0, {-centre, Quat::Identity()}});
  }
  for (std::size_t i = 0; i + 1 < 9; ++i) scan.cloud.pairs.push_back({i, i + 1, 0.5});
  scan.cloud.blurred = {3};
  const CameraRing ring = compute_camera_ring(scan, block_from_model);
  ASSERT_EQ(ring.cameras.size(), 9u);
  EXPECT_NEAR(ring.cameras[5].azimuth, -120.0 * kRadiansPerDegree, 1e-12);
  EXPECT_NEAR(ring.cameras[5].elevation, 20.0 * kRadiansPerDegree, 1e-12);
  EXPECT_NEAR(ring.cameras[5].distance, 2.0, 1e-12);
  EXPECT_EQ(ring.cameras[0].pairs, 1u);
  EXPECT_EQ(ring.cameras[4].pairs, 2u);
  EXPECT_TRUE(ring.cameras[3].blurred);
  EXPECT_NEAR(ring.largest_gap, 120.0 * kRadiansPerDegree, 1e-12);
  EXPECT_NEAR(std::abs(ring.gap_azimuth), kPi, 1e-12);
  // Every 30 degrees is wide; the widest goes from the fifth seat to the sixth, past 180 degrees.
  ASSERT_EQ(ring.gaps.size(), 9u);
  const AzimuthGap& widest = ring.gaps.back();
  EXPECT_EQ(widest.first, 4u);
  EXPECT_EQ(widest.second, 5u);
  EXPECT_NEAR(widest.from, 120.0 * kRadiansPerDegree, 1e-12);
  EXPECT_NEAR(widest.width, 120.0 * kRadiansPerDegree, 1e-12);
}

}  // namespace
}  // namespace clast
