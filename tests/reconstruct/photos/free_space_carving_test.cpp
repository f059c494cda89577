/// What pairs look through, with depths of a ball on a plane that are exact.
#include "reconstruct/photos/detail/free_space_carving.hpp"
#include "core/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clast::photos_detail {
namespace {

/// A ball of radius 1 about the origin that stands on the plane z = -1.
double distance_to_scene(const Vec3& from, const Vec3& way) {
  double nearest = way.z() < 0.0 ? (-1.0 - from.z()) / way.z() : 1e9;
  const double along = from.dot(way), rest = along * along - from.squaredNorm() + 1.0;
  if (rest > 0.0 && -along - std::sqrt(rest) > 0.0) {
    nearest = std::min(nearest, -along - std::sqrt(rest));
  }
  return nearest;
}

/// A camera 8 from the ball's centre, with the depths of all that it sees within 2 of it.
DisparityMap pair_from(double around, double up) {
  const Vec3 out(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
  const Vec3 right = (-out).cross(Vec3::UnitZ()).normalized();
  DisparityMap pair;
  Rectification& r = pair.view;
  r.rotation << right.transpose(), (-out).cross(right).transpose(), -out.transpose();
  r.left = 8.0 * out;
  r.f = 400.0;
  r.cx = r.cy = 120.0;
  r.width = r.height = 241;
  r.baseline = 2.0;
  r.offset = r.f * r.baseline / 8.0;
  pair.disparity = cv::Mat(r.height, r.width, CV_16S, cv::Scalar(kNoDisparity));
  for (int v = 0; v < r.height; ++v) {
    for (int u = 0; u < r.width; ++u) {
      const Vec3 ray((u - r.cx) / r.f, (v - r.cy) / r.f, 1.0);
      const Vec3 way = r.rotation.transpose() * ray.normalized();
      const double length = distance_to_scene(r.left, way);
      if ((r.left + length * way).norm() > 2.0) continue;
      const double depth = length / ray.norm();
      pair.disparity.at<short>(v, u) =
          static_cast<short>(std::lround(16.0 * (r.f * r.baseline / depth - r.offset)));
    }
  }
  return pair;
}

class LookedThrough : public testing::Test {
 protected:
  LookedThrough() {
    for (int i = 0; i < 12; ++i) {
      for (const double up : {22.0, 50.0}) {
        pairs_.push_back(pair_from(30.0 * i * kRadiansPerDegree, up * kRadiansPerDegree));
      }
    }
    for (const DisparityMap& pair : pairs_) {
      views_.emplace_back(pair);
      agreed_.push_back((pair.disparity != kNoDisparity) / 255);
    }
  }
  std::vector<DisparityMap> pairs_;
  std::vector<PairProjection> views_;
  std::vector<cv::Mat> agreed_;
  PhotoRegion region_{Vec3::Zero(), 2.0, true};
};

TEST_F(LookedThrough, NoCubeOfTheBallAndMostOfWhatIsAroundItsFoot) {
  const FreeSpaceGrid free_space = carve_free_space(views_, agreed_, region_, 1.0, 2);
  std::size_t low = 0, empty = 0;
  for (std::size_t i = 0; i < free_space.is_free_cell.size(); ++i) {
    const Vec3 position = free_space.cell_centre(i);
    const bool rock = position.norm() < 1.0 || position.z() < -1.0;
    ASSERT_FALSE(rock && free_space.is_free_cell[i]) << position.transpose();
    ASSERT_EQ(free_space.is_free(position), free_space.is_free_cell[i] != 0);
    // Beside the ball's lower half, where some camera looks past it, away from ball and ground.
    if (position.norm() < 1.25 || position.norm() > 1.5 || position.z() > 0.0 ||
        position.z() < -0.8)
      continue;
    ++low;
    empty += free_space.is_free_cell[i];
  }
  EXPECT_GT(low, 10000u);
  EXPECT_GT(static_cast<double>(empty), 0.95 * static_cast<double>(low));
  EXPECT_FALSE(free_space.is_free(Vec3(0.0, 0.0, 50.0)));
}

TEST_F(LookedThrough, WhatOthersDoNotAgreeWithOpensNothing) {
  for (cv::Mat& mask : agreed_) mask.setTo(0);
  const FreeSpaceGrid free_space = carve_free_space(views_, agreed_, region_, 1.0, 2);
  EXPECT_EQ(std::count(free_space.is_free_cell.begin(), free_space.is_free_cell.end(), 1), 0);
}

// A pair whose depths are wrong can't open a cube alone.
TEST_F(LookedThrough, OneWrongPairOpensNothing) {
  const std::vector<PairProjection> one = {views_[0]};
  const FreeSpaceGrid free_space = carve_free_space(one, {agreed_[0]}, region_, 1.0, 1);
  EXPECT_EQ(std::count(free_space.is_free_cell.begin(), free_space.is_free_cell.end(), 1), 0);
}

TEST_F(LookedThrough, IsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(carve_free_space(views_, agreed_, region_, 1.0, 1).is_free_cell,
            carve_free_space(views_, agreed_, region_, 1.0, 3).is_free_cell);
}

}  // namespace
}  // namespace clast::photos_detail
