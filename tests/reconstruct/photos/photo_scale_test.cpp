/// Scales from made-up markers: agreement, wrong sizes, refusals.
#include "reconstruct/photos/photo_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "reconstruct/photos/detail/triangulation.hpp"
#include "tests/support/made_up_markers.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::vector<LocatedMarker> four() {
  return {made_up_marker(0, {1.0, 0.0, 0.0}), made_up_marker(1, {0.0, 2.0, 0.0}),
          made_up_marker(4, {-2.0, 0.0, 0.1}), made_up_marker(7, {0.0, -1.0, 0.0})};
}

TEST(PhotoScale, AKnownDistanceSetsIt) {
  // Centres 0 and 4 are |(3, 0, -0.1)| units apart.
  const PhotoScale scale = estimate_scale_from_markers(four(), {.bars = {{0, 4, 1.5}}});
  EXPECT_NEAR(scale.metres_per_unit, 1.5 / std::hypot(3.0, 0.1), 1e-12);
  EXPECT_TRUE(scale.from_bars);
  ASSERT_EQ(scale.notes.size(), 1u);
  EXPECT_TRUE(contains(scale.notes[0], "without a check"));
}

TEST(PhotoScale, TheSideSetsItAndEachMarkerIsCheckedByTheOthers) {
  std::vector<LocatedMarker> markers = four();
  markers[1] = made_up_marker(1, {0.0, 2.0, 0.0}, 0.4012);
  const PhotoScale scale = estimate_scale_from_markers(markers, {.marker_side = 0.2});
  const double other = 0.2 / 0.4012;
  EXPECT_NEAR(scale.metres_per_unit, (3.0 * 0.5 + other) / 4.0, 1e-12);
  EXPECT_NEAR(scale.measures[1].leave_one_out_error, 0.4012 / 0.4 - 1.0, 1e-12);
  const double mean = scale.metres_per_unit;
  EXPECT_NEAR(
      scale.spread,
      std::sqrt((3.0 * std::pow(0.5 / mean - 1.0, 2) + std::pow(other / mean - 1.0, 2)) / 3.0),
      1e-12);
  EXPECT_TRUE(scale.notes.empty());
}

TEST(PhotoScale, AMarkerOfAnotherSizeIsNamedAndLeftOut) {
  std::vector<LocatedMarker> markers = four();
  markers[2] = made_up_marker(4, {-2.0, 0.0, 0.1}, 0.4 * 1.018);
  const PhotoScale scale = estimate_scale_from_markers(markers, {.marker_side = 0.2});
  EXPECT_NEAR(scale.metres_per_unit, 0.5, 1e-12);
  EXPECT_FALSE(scale.measures[2].used);
  ASSERT_EQ(scale.notes.size(), 1u);
  EXPECT_TRUE(contains(scale.notes[0], "marker 4 disagrees by 1.8 % with the other 3"));
}

TEST(PhotoScale, ABarThatIsWrongIsNamedAndLeftOut) {
  const PhotoScale scale = estimate_scale_from_markers(
      four(), {.bars = {{0, 1, 0.5 * std::sqrt(5.0)}, {0, 7, 0.5 * std::sqrt(2.0)}, {1, 7, 1.6}}});
  EXPECT_NEAR(scale.metres_per_unit, 0.5, 1e-12);
  ASSERT_EQ(scale.notes.size(), 1u);
  EXPECT_TRUE(contains(scale.notes[0], "markers 1 and 7 disagrees"));
}

TEST(PhotoScale, SidesCheckBars) {
  const PhotoScale good =
      estimate_scale_from_markers(four(), {.bars = {{1, 7, 1.5}}, .marker_side = 0.2});
  ASSERT_TRUE(good.marker_side_ratio.has_value());
  EXPECT_NEAR(*good.marker_side_ratio, 0.0, 1e-12);
  const PhotoScale bad =
      estimate_scale_from_markers(four(), {.bars = {{1, 7, 1.5}}, .marker_side = 0.19});
  EXPECT_NEAR(*bad.marker_side_ratio, 0.2 / 0.19 - 1.0, 1e-12);
  EXPECT_TRUE(contains(bad.notes.back(), "sides of the markers are 5.3 % longer than given"));
}

TEST(PhotoScale, SizesThatContradictAreRefused) {
  const std::vector<LocatedMarker> two = {made_up_marker(0, {1.0, 0.0, 0.0}),
                                          made_up_marker(1, {0.0, 2.0, 0.0}, 0.45)};
  EXPECT_TRUE(contains(refusal([&] { estimate_scale_from_markers(two, {.marker_side = 0.2}); }),
                       "marker 0: 0.5 m per unit, marker 1: 0.444444 m per unit"));
}

TEST(PhotoScale, WhatCantSetAScaleIsRefused) {
  const std::vector<LocatedMarker> markers = four();
  EXPECT_TRUE(contains(refusal([&] { estimate_scale_from_markers(markers, {}); }), "no scale"));
  EXPECT_TRUE(contains(refusal([&] { estimate_scale_from_markers({}, {.marker_side = 0.2}); }),
                       "no marker was found"));
  EXPECT_TRUE(contains(refusal([&] {
                         estimate_scale_from_markers(markers, {.bars = {{0, 9, 1.0}}});
                       }),
                       "marker 9 was not found; found 0, 1, 4, 7"));
  EXPECT_TRUE(contains(refusal([&] {
                         estimate_scale_from_markers(markers, {.bars = {{0, 0, 1.0}}});
                       }),
                       "both ends"));
  EXPECT_TRUE(contains(refusal([&] {
                         estimate_scale_from_markers(markers, {.bars = {{0, 1, -1.0}}});
                       }),
                       "can't be a distance"));
  EXPECT_TRUE(contains(refusal([&] { estimate_scale_from_markers(markers, {.marker_side = 0.0}); }),
                       "can't be the side"));
}

TEST(Triangulation, PlacesComeBackThoughAThirdOfTheSightingsAreWrong) {
  PhotoModel model;
  model.lenses.push_back({.width = 1600,
                          .height = 1200,
                          .fx = 1500.0,
                          .fy = 1500.0,
                          .cx = 800.0,
                          .cy = 600.0,
                          .radial = {-0.05, 0.01, 0.0, 0.0}});
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.3 * i;
    const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitY()));
    model.photos.push_back({"p", {}, 0, {Vec3(0.0, 0.0, 2.0), turn}});
  }
  const Vec3 truth(0.1, -0.2, 0.15);
  Random random(8);
  std::vector<photos_detail::ImageObservation> observations;
  for (std::size_t i = 0; i < 12; ++i) {
    Vec2 pixel = *project_into_photo(model, i, truth);
    if (i % 3 == 0) pixel += Vec2(random.uniform(10.0, 90.0), random.uniform(-70.0, 70.0));
    observations.push_back({i, pixel});
  }
  const auto found = photos_detail::triangulate(model, observations, 2.0);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->inlier_count, 8u);
  EXPECT_NEAR((found->position - truth).norm(), 0.0, 1e-9);
  EXPECT_FALSE(photos_detail::triangulate(model, {observations[1]}, 2.0).has_value());
}

}  // namespace
}  // namespace clast
