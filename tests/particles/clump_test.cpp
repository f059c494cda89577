#include "particles/clump.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/triangle_tree.hpp"
#include "particles/ball_union.hpp"
#include "samples/rock_shapes.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

ParticleBody rock_body() {
  return make_particle_body(
      rock({.name = "rock", .lengths = {1.2, 0.9, 0.7}, .frequency = 8, .seed = 4}));
}

TEST(Clump, KeepsTheErrorsAskedFor) {
  const ParticleBody body = rock_body();
  const ShapeErrors limits = {.volume = 0.01, .inertia = 0.02, .surface = 0.06};
  const Clump clump = fit_clump(body, {.error = limits});
  EXPECT_TRUE(clump.errors.is_within(limits)) << format_shape_errors(clump.errors);
  EXPECT_LT(clump.balls.size(), 40u);
  EXPECT_LT(clump.errors.volume, 1e-3);
  for (std::size_t i = 1; i < clump.balls.size(); ++i) {
    EXPECT_LE(clump.balls[i].radius, clump.balls[i - 1].radius);
  }
  EXPECT_GE(clump.balls.back().radius, 0.02 * body.length * (1.0 - 1e-9));
  const MassProperties own = ball_union_mass_properties(clump.balls, 1.0);
  EXPECT_LT((own.centre - body.mass.centre).norm(), 1e-3 * body.length);
}

TEST(Clump, HasTheNumberOfSpheresAskedFor) {
  for (const std::size_t count : {1u, 3u, 14u}) {
    EXPECT_EQ(fit_clump(rock_body(), {.balls = count}).balls.size(), count);
  }
}

TEST(Clump, IsTheSameForTheSameBody) {
  const Clump first = fit_clump(rock_body(), {.balls = 10});
  const Clump second = fit_clump(rock_body(), {.balls = 10});
  for (std::size_t i = 0; i < first.balls.size(); ++i) {
    EXPECT_EQ(first.balls[i].centre, second.balls[i].centre);
    EXPECT_EQ(first.balls[i].radius, second.balls[i].radius);
  }
}

TEST(Clump, GrowsWithTheBody) {
  ParticleBody body = rock_body();
  const Clump small = fit_clump(body, {.balls = 8});
  const Clump large = fit_clump(make_particle_body(scaled(body.mesh, 1024.0)), {.balls = 8});
  for (std::size_t i = 0; i < small.balls.size(); ++i) {
    EXPECT_NEAR(large.balls[i].radius, 1024.0 * small.balls[i].radius, 1e-3);
  }
}

TEST(Clump, SurfaceErrorIsTheLargestDistanceByAnotherSample) {
  const ParticleBody body = make_particle_body(cuboid(3.0, 2.0, 1.0));
  const std::vector<Ball> balls = {{Vec3::Zero(), 0.5}};
  // The largest distance is that from a corner of the cuboid to the ball.
  EXPECT_NEAR(measure_clump_errors(body, balls).surface, (Vec3(1.5, 1.0, 0.5).norm() - 0.5) / 3.0,
              1e-9);
  // The ball around the cuboid: its poles above the large faces.
  const double around = Vec3(1.5, 1.0, 0.5).norm();
  EXPECT_NEAR(measure_clump_errors(body, {{{Vec3::Zero(), around}}}).surface, (around - 0.5) / 3.0,
              1e-3);
}

TEST(Clump, ErrorsOfMassCompareTensorsAtEqualMass) {
  const MassProperties body = {1.0, 2.0, Vec3::Zero(), Vec3(2.0, 3.0, 4.0).asDiagonal()};
  MassProperties shape = {1.1, 4.0, Vec3::Zero(), Vec3(4.0, 6.0, 8.0).asDiagonal()};
  shape.inertia(0, 1) = shape.inertia(1, 0) = 0.4;
  const ShapeErrors errors = compare_mass_properties(shape, body);
  EXPECT_NEAR(errors.volume, 0.1, 1e-12);
  EXPECT_NEAR(errors.inertia, 0.1, 1e-12);
}

TEST(Clump, LevelsAreFittedToEachError) {
  const std::vector<Clump> levels =
      fit_clump_levels(rock_body(), {.error = {0.05, 0.05, 0.02}}, {0.15, 0.1});
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_LE(levels[0].errors.surface, 0.15);
  EXPECT_LE(levels[1].errors.surface, 0.1);
  EXPECT_LT(levels[0].balls.size(), levels[1].balls.size());
}

TEST(Clump, ErrorsOutOfReachAreRefusedWithWhatWasReached) {
  const std::string message = refusal<GeometryError>([&] {
    fit_clump(rock_body(), {.error = {0.01, 0.02, 0.01}, .max_balls = 5});
  });
  EXPECT_TRUE(contains(message, "not reached with 5 spheres")) << message;
  EXPECT_TRUE(contains(message, "reached: volume")) << message;
}

TEST(Clump, OptionsOutOfRangeAreRefused) {
  const auto refused = [&](const ClumpOptions& options) {
    return refusal<InputError>([&] { fit_clump(rock_body(), options); });
  };
  EXPECT_TRUE(contains(refused({.error = {0.0, 0.1, 0.1}}), "`error` volume = 0"));
  EXPECT_TRUE(contains(refused({.error = {0.1, 0.1, 1.0}}), "`error` surface = 1"));
  EXPECT_TRUE(contains(refused({.balls = 0}), "`equal_spheres` = 0"));
  EXPECT_TRUE(contains(refused({.max_balls = 0}), "`max_spheres` = 0"));
  EXPECT_TRUE(contains(refused({.smallest_sphere = 0.0}), "`smallest_sphere` = 0"));
}

}  // namespace
}  // namespace clast
