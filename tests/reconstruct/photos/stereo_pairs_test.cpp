/// Which photos are compared, on rings of made-up cameras around the origin.
#include "reconstruct/photos/stereo_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.hpp"
#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Cameras in a ring at a height angle, looking at a place.
void add_ring(PhotoModel& model, int count, double elevation, const Vec3& at = Vec3::Zero()) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * i / count;
    const Vec3 out(std::cos(elevation) * std::cos(angle), std::cos(elevation) * std::sin(angle),
                   std::sin(elevation));
    const Vec3 right = (-out).cross(Vec3::UnitZ()).normalized();
    Mat3 rotation;
    rotation << right.transpose(), (-out).cross(right).transpose(), -out.transpose();
    const Vec3 centre = at + 3.0 * out;
    model.photos.push_back(
        {"p" + std::to_string(model.photos.size()), {}, 0, {-(rotation * centre), Quat(rotation)}});
  }
}

PhotoModel with_lens() {
  PhotoModel model;
  model.lenses.push_back(
      {.width = 1600, .height = 1200, .fx = 1500.0, .fy = 1500.0, .cx = 800.0, .cy = 600.0});
  return model;
}

TEST(StereoPairs, EveryPhotoOfARingIsPairedWithItsNeighboursOnBothSides) {
  PhotoModel model = with_lens();
  add_ring(model, 24, 0.0);
  const std::vector<StereoPair> pairs = choose_stereo_pairs(model, {Vec3::Zero(), 0.5, true});
  ASSERT_EQ(pairs.size(), 24u);
  std::vector<int> partners(24);
  for (const StereoPair& pair : pairs) {
    EXPECT_NEAR(pair.angle, 15.0 * kRadiansPerDegree, 1e-9);
    ++partners[pair.first];
    ++partners[pair.second];
  }
  for (const int count : partners) EXPECT_EQ(count, 2);
}

TEST(StereoPairs, BlurredPhotosAndThoseThatLookAwayAreLeftOut) {
  PhotoModel model = with_lens();
  add_ring(model, 24, 0.0);
  model.photos[5].camera_from_world = {Vec3::Zero(), Random(1).rotation()};
  const std::vector<StereoPair> pairs =
      choose_stereo_pairs(model, {Vec3::Zero(), 0.5, true}, {7, 9});
  for (const StereoPair& pair : pairs) {
    for (const std::size_t out : {5u, 7u, 9u}) {
      EXPECT_NE(pair.first, out);
      EXPECT_NE(pair.second, out);
    }
  }
}

TEST(StereoPairs, PhotosTooFarApartAreToldWithTheirAngle) {
  PhotoModel model = with_lens();
  add_ring(model, 7, 0.0);  // 51.4 degrees
  const std::string text = refusal([&] { choose_stereo_pairs(model, {Vec3::Zero(), 0.5, true}); });
  EXPECT_TRUE(contains(text, "only 0 pairs among 7 photos"));
  EXPECT_TRUE(contains(text, "neighbours are 51 degrees apart"));
  EXPECT_TRUE(contains(text, "every 10-15 degrees"));
}

TEST(PhotoRegion, WithoutGroundItHoldsThePointsThatCamerasLookAt) {
  PhotoModel model = with_lens();
  const Vec3 at(0.4, -0.3, 0.2);
  add_ring(model, 12, 0.3, at);
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = at + 0.5 * std::cbrt(random.uniform()) * random.unit_vector();
    model.points.push_back({p, {0, 1, 2}});
  }
  const PhotoRegion region = find_photo_region(model);
  EXPECT_FALSE(region.from_ground);
  EXPECT_NEAR((region.centre - at).norm(), 0.0, 1e-9);
  // Nine tenths of a ball of points lie within 0.9^(1/3) of its radius; a margin of 15 % is added.
  EXPECT_NEAR(region.radius, 1.15 * 0.5 * std::cbrt(0.9), 0.01);
}

TEST(PhotoRegion, ABlockOnAGroundIsHeldWithAMargin) {
  PhotoModel model = with_lens();
  add_ring(model, 12, 0.4);
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    Vec3 p = 0.4 * random.unit_vector();  // a ball on the ground
    if (i % 2 == 0) p = {random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), -0.35};
    if (p.z() < -0.35 || (i % 2 == 0 && p.head<2>().norm() < 0.2)) continue;
    model.points.push_back({p + 0.002 * random.unit_vector(), {0, 1, 2}});
  }
  const PhotoRegion region = find_photo_region(model);
  EXPECT_TRUE(region.from_ground);
  EXPECT_LT(region.centre.norm(), 0.05);
  EXPECT_GT(region.radius, 0.4);
  EXPECT_LT(region.radius, 0.55);
}

TEST(PhotoRegion, CamerasThatLookAtNothingTogetherAreRefused) {
  PhotoModel model = with_lens();
  for (int i = 0; i < 5; ++i) {
    model.photos.push_back({"p", {}, 0, {Vec3(0.1 * i, 0.0, 0.0), Quat::Identity()}});
  }
  EXPECT_TRUE(contains(refusal([&] { find_photo_region(model); }), "parallel"));
  model.photos.resize(1);
  EXPECT_TRUE(contains(refusal([&] { find_photo_region(model); }), "too few"));
}

}  // namespace
}  // namespace clast
