/// The lens against OpenCV's own projection, and against its inverse.
#include "reconstruct/photos/lens.hpp"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

CameraIntrinsics odd_lens() {
  CameraIntrinsics lens{
      .width = 4000, .height = 3000, .fx = 3100.0, .fy = 3080.0, .cx = 2011.3, .cy = 1480.7};
  lens.radial = {-0.11, 0.06, -0.012, 0.0};
  lens.radial_divisor = {0.02, -0.01, 0.003};
  lens.p1 = 0.0007;
  lens.p2 = -0.0011;
  return lens;
}

Vec3 before_camera(Random& random) {
  return {random.uniform(-1.2, 1.2), random.uniform(-0.9, 0.9), random.uniform(2.0, 5.0)};
}

TEST(CameraIntrinsics, ProjectsAsOpenCvDoes) {
  const CameraIntrinsics lens = odd_lens();
  const cv::Matx33d k(lens.fx, 0.0, lens.cx, 0.0, lens.fy, lens.cy, 0.0, 0.0, 1.0);
  const std::vector<double> distortion = {lens.radial[0],
                                          lens.radial[1],
                                          lens.p1,
                                          lens.p2,
                                          lens.radial[2],
                                          lens.radial_divisor[0],
                                          lens.radial_divisor[1],
                                          lens.radial_divisor[2]};
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = before_camera(random);
    std::vector<cv::Point2d> expected;
    cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(), cv::Vec3d(), k,
                      distortion, expected);
    const std::optional<Vec2> found = project(lens, p);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->x(), expected[0].x, 1e-8);
    EXPECT_NEAR(found->y(), expected[0].y, 1e-8);
  }
}

TEST(CameraIntrinsics, FisheyeProjectsAsOpenCvDoes) {
  CameraIntrinsics lens{
      .width = 2000, .height = 2000, .fx = 600.0, .fy = 610.0, .cx = 990.0, .cy = 1005.0};
  lens.radial = {0.03, -0.01, 0.004, -0.0006};
  lens.fisheye = true;
  const cv::Matx33d k(lens.fx, 0.0, lens.cx, 0.0, lens.fy, lens.cy, 0.0, 0.0, 1.0);
  const cv::Vec4d distortion(0.03, -0.01, 0.004, -0.0006);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(1.0, 2.0));
    std::vector<cv::Point2d> expected;
    cv::fisheye::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, expected,
                               cv::Vec3d(), cv::Vec3d(), k, distortion);
    const std::optional<Vec2> found = project(lens, p);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->x(), expected[0].x, 1e-8);
    EXPECT_NEAR(found->y(), expected[0].y, 1e-8);
  }
}

TEST(CameraIntrinsics, DirectionAtAPixelIsSeenThere) {
  CameraIntrinsics fisheye{
      .width = 2000, .height = 2000, .fx = 600.0, .fy = 610.0, .cx = 990.0, .cy = 1005.0};
  fisheye.radial = {0.03, -0.01, 0.004, -0.0006};
  fisheye.fisheye = true;
  CameraIntrinsics skewed = odd_lens();
  skewed.skew = 2.5;
  for (const CameraIntrinsics& lens : {odd_lens(), fisheye, skewed}) {
    Random random(11);
    for (int i = 0; i < 200; ++i) {
      // A fisheye's corners may be beyond a right angle.
      const Vec2 pixel(random.uniform(0.2, 0.8) * lens.width,
                       random.uniform(0.2, 0.8) * lens.height);
      const std::optional<Vec3> direction = unproject(lens, pixel);
      ASSERT_TRUE(direction.has_value());
      EXPECT_NEAR((*project(lens, 2.7 * *direction) - pixel).norm(), 0.0, 1e-8);
    }
  }
}

TEST(CameraIntrinsics, WhatIsBehindOrBeyondTheDistortionIsNotSeen) {
  EXPECT_FALSE(project(odd_lens(), {0.1, 0.1, -1.0}).has_value());
  EXPECT_FALSE(project(odd_lens(), {0.1, 0.1, 0.0}).has_value());
  // r (1 - 0.3 r^2) falls where 0.9 r^2 > 1.
  CameraIntrinsics barrel{
      .width = 1000, .height = 1000, .fx = 500.0, .fy = 500.0, .cx = 500.0, .cy = 500.0};
  barrel.radial[0] = -0.3;
  EXPECT_TRUE(project(barrel, {1.05, 0.0, 1.0}).has_value());
  EXPECT_FALSE(project(barrel, {1.06, 0.0, 1.0}).has_value());
}

TEST(CameraIntrinsics, ASmallerPhotoSeesTheSamePlacesOfItsFrame) {
  const CameraIntrinsics lens = odd_lens(), half = resized_intrinsics(lens, 2000, 1500);
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = before_camera(random);
    // Pixel edges halve: u + 0.5 is the distance from the photo's edge.
    const Vec2 expected = 0.5 * (*project(lens, p) + Vec2(0.5, 0.5)) - Vec2(0.5, 0.5);
    EXPECT_NEAR((*project(half, p) - expected).norm(), 0.0, 1e-9);
  }
  EXPECT_TRUE(contains(refusal([&] { resized_intrinsics(lens, 1500, 2000); }), "1500 x 2000"));
  EXPECT_TRUE(
      contains(refusal([&] { resized_intrinsics(lens, 2000, 1200); }), "not cropped or rotated"));
}

TEST(CameraIntrinsics, ValuesOfNoLensAreRefused) {
  CameraIntrinsics lens = odd_lens();
  lens.fx = -3.0;
  EXPECT_TRUE(contains(refusal([&] { lens.check(); }), "focal length"));
  lens = odd_lens();
  lens.width = 0;
  EXPECT_TRUE(contains(refusal([&] { lens.check(); }), "width"));
  lens = odd_lens();
  lens.radial[2] = std::nan("");
  EXPECT_TRUE(contains(refusal([&] { lens.check(); }), "distortion"));
}

}  // namespace
}  // namespace clast
