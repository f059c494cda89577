#include "shapes/core_fit.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "shapes/rounding.hpp"
#include "shapes/surface_deviation.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(CoreFit, CubeCornersStandOutAndFallShortByTheSame) {
  // A ball of radius r that stands h out of three faces of a cube has its centre r - h behind them,
  // and ends (r - h) sqrt 3 - r short of the corner. Equal for h = r (sqrt 3 - 1) / (sqrt 3 + 1),
  // 0.27 r; the inset alone is 0.73 r short. A fit comes within half of that.
  const double r = 0.1, inset = r * (std::sqrt(3.0) - 1.0);
  const double best = inset / (std::sqrt(3.0) + 1.0);
  const TriangleMesh cube = box_mesh({1, 1, 1}, 4);
  const SpheroPolyhedron body =
      fit_core(cube, inset_core(cube, r),
               {.target_distance = 0.45 * inset, .max_distance = 0.5 * inset})
          .body;
  const SurfaceDeviation deviation = measure_surface_deviation(cube, body);
  EXPECT_GE(deviation.hausdorff, best - 1e-9) << "nothing can be nearer";
  EXPECT_LT(deviation.hausdorff, 0.5 * inset);
}

class FittedRocks : public testing::TestWithParam<int> {};

TEST_P(FittedRocks, AreNearerAndStaySound) {
  const TriangleMesh rock = random_rock(GetParam(), 2, 0.1);
  const SpheroPolyhedron start = inset_core(rock, 0.15);
  const SpheroPolyhedron body = fit_core(rock, start).body;
  const double before = measure_surface_deviation(rock, start).hausdorff;
  EXPECT_LT(measure_surface_deviation(rock, body).hausdorff, before);
  EXPECT_EQ(body.radius, start.radius);
  EXPECT_LE(body.vertices.size(), start.vertices.size());
  const TriangleMesh core = core_mesh(body);
  EXPECT_TRUE(inspect_mesh(core).is_closed() && inspect_mesh(core).is_oriented());
  EXPECT_TRUE(find_self_intersections(core).empty());
}

TEST_P(FittedRocks, FollowARigidMotion) {
  const TriangleMesh rock = random_rock(GetParam(), 2, 0.1);
  const Pose pose{Vec3(3, -2, 5), Random(7).rotation()};
  const double there =
      measure_surface_deviation(rock, fit_core(rock, inset_core(rock, 0.15)).body).hausdorff;
  const TriangleMesh moved = transformed(rock, pose);
  const double here =
      measure_surface_deviation(moved, fit_core(moved, inset_core(moved, 0.15)).body).hausdorff;
  EXPECT_NEAR(here, there, 0.25 * there);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FittedRocks, testing::Range(0, 2));

TEST(CoreFit, SameInputGivesTheSameBits) {
  const TriangleMesh rock = random_rock(5, 2, 0.1);
  const SpheroPolyhedron start = inset_core(rock, 0.05);
  EXPECT_EQ(fit_core(rock, start).body.vertices, fit_core(rock, start).body.vertices);
}

TEST(CoreFit, SameBitsOnAnyNumberOfThreads) {
  const TriangleMesh rock = random_rock(6, 3, 0.1);
  const SpheroPolyhedron start = inset_core(rock, 0.1);
  const CoreFitOptions one{.target_distance = 0.02, .max_distance = 0.021};
  CoreFitOptions four = one;
  four.threads = 4;
  EXPECT_EQ(fit_core(rock, start, one).body.vertices, fit_core(rock, start, four).body.vertices);
}

TEST_P(FittedRocks, KeepTheDistanceBoundThatTheyState) {
  const TriangleMesh rock = random_rock(GetParam(), 3, 0.1);
  const SpheroPolyhedron start = inset_core(rock, 0.1);
  const double before = measure_surface_deviation(rock, start).hausdorff;
  const CoreFit fit =
      fit_core(rock, start, {.target_distance = 0.7 * before, .max_distance = 0.75 * before});
  ASSERT_EQ(fit.distance_bound, 0.75 * before);
  EXPECT_LE(measure_surface_deviation(rock, fit.body).hausdorff, fit.distance_bound);
}

TEST(CoreFit, CorrectsTheBodyBeforeItIsChecked) {
  const TriangleMesh rock = random_rock(6, 2, 0.1);
  const SpheroPolyhedron start = inset_core(rock, 0.1);
  const double before = measure_surface_deviation(rock, start).hausdorff;
  const auto shrink = [](SpheroPolyhedron body) {
    for (Vec3& vertex : body.vertices) vertex *= 0.99;
    return body;
  };
  CoreFitOptions options{.target_distance = before, .max_distance = 1.5 * before};
  options.correct = shrink;
  const CoreFit fit = fit_core(rock, start, options);
  EXPECT_EQ(fit.body.vertices, shrink(start).vertices);
  options.max_distance = options.target_distance = 1e-4;  // cannot be reached
  EXPECT_EQ(fit_core(rock, start, options).distance_bound, 1e300);
}

TEST(CoreFit, GoodEnoughIsLeftAlone) {
  const TriangleMesh rock = random_rock(5, 2, 0.1);
  const SpheroPolyhedron start = inset_core(rock, 0.05);
  EXPECT_EQ(fit_core(rock, start, {.target_distance = 1.0}).body.vertices, start.vertices);
  EXPECT_EQ(fit_core(rock, start, {.rounds = 0}).body.vertices, start.vertices);
}

TEST(CoreFit, NonsenseIsRefused) {
  const TriangleMesh rock = random_rock(5, 2, 0.04);
  EXPECT_THROW(fit_core(rock, {}), GeometryError);
  EXPECT_THROW(fit_core(TriangleMesh{}, make_sphero_polyhedron(rock, 0.1)), GeometryError);
  EXPECT_THROW(fit_core(rock, make_sphero_polyhedron(rock, 0.1), {.rounds = -1}), InputError);
  EXPECT_THROW(fit_core(rock, make_sphero_polyhedron(rock, 0.1), {.target_distance = -1.0}),
               InputError);
}

}  // namespace
}  // namespace clast
