// Bodies stretched to the ratios of a smallest box.
#include "shapes/box_stretch.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/self_intersection.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

SpheroPolyhedron rock(std::uint64_t seed, double radius = 0.02) {
  return make_sphero_polyhedron(rock_mesh(4, Vec3(1.0, 0.7, 0.5), seed, 0.25), radius);
}

class StretchOfRocks : public testing::TestWithParam<std::uint64_t> {};

TEST_P(StretchOfRocks, ReachesFormsAllOverTheTriangleOfSneedAndFolk) {
  const SpheroPolyhedron body = rock(GetParam());
  for (const BoxRatios target : {BoxRatios{1.0, 1.0},
                                 {1.0, 0.2},
                                 {0.2, 0.2},
                                 {0.6, 0.2},
                                 {0.75, 0.5},
                                 {0.5, 0.5},
                                 {1.0, 0.6}}) {
    const StretchedBody result = stretch_to_ratios(body, target);
    EXPECT_LT(max_ratio_difference(box_ratios(smallest_box(result.body)), target), 1e-3);
    EXPECT_TRUE(find_self_intersections(core_mesh(result.body)).empty());
    EXPECT_NEAR(result.principal_stretches.prod(), 1.0, 1e-9);
    EXPECT_NEAR(enclosed_volume(core_mesh(result.body)), enclosed_volume(core_mesh(body)), 1e-9);
    EXPECT_NEAR(result.body.radius / smallest_box(result.body).lengths[2],
                body.radius / smallest_box(body).lengths[2], 1e-4);
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, StretchOfRocks, testing::Range<std::uint64_t>(1, 4));

TEST(BoxStretch, ItsOwnRatiosLeaveABodyAsItIs) {
  const SpheroPolyhedron body = rock(7);
  const StretchedBody result = stretch_to_ratios(body, box_ratios(smallest_box(body)));
  EXPECT_EQ(result.body.vertices, body.vertices);
  EXPECT_EQ(result.body.radius, body.radius);
  EXPECT_EQ(result.principal_stretches, Vec3(1.0, 1.0, 1.0));
}

// A box stretched along its sides is a box: the stretches are known.
TEST(BoxStretch, OfABoxIsThatOfItsSides) {
  const SpheroPolyhedron box = make_sphero_polyhedron(box_mesh(Vec3(3.0, 2.0, 1.0)), 0.0);
  const StretchedBody result = stretch_to_ratios(box, {1.0, 0.5});
  const double side = std::cbrt(6.0 / 0.5);
  EXPECT_NEAR(result.principal_stretches[0], side / 2.0, 1e-9);
  EXPECT_NEAR(result.principal_stretches[1], 0.5 * side / 1.0, 1e-9);
  EXPECT_NEAR(result.principal_stretches[2], side / 3.0, 1e-9);
}

TEST(BoxStretch, RefusesWhatHasNoFormAndRatiosThatAreNone) {
  SpheroPolyhedron ball;
  ball.vertices = {Vec3::Zero()};
  ball.radius = 1.0;
  EXPECT_TRUE(contains(refusal<GeometryError>([&] {
                         stretch_to_ratios(ball, {0.5, 0.5});
                       }),
                       "ball"));
  EXPECT_TRUE(contains(refusal([&] { stretch_to_ratios(rock(1), {1.2, 0.5}); }), "I/L = 1.2"));
  EXPECT_TRUE(contains(refusal([&] { stretch_to_ratios(rock(1), {0.5, 0.6}); }), "S/L = 0.6"));
  EXPECT_TRUE(contains(refusal([&] { stretch_to_ratios(rock(1), {0.5, NAN}); }), "S/L = nan"));
}

}  // namespace
}  // namespace clast
