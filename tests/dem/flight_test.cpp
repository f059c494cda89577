// Motion without contact, and where it ends.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/gravity.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

struct Landing {
  double time = -1.0;
  RigidState state;
  int flight_segments = 0;
};

Landing first_landing(const TerrainSurface& terrain, const RigidBody& body, const RigidState& start,
                      double duration) {
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.max_time = duration;
  Landing landing;
  simulate_release(terrain, std::vector<GroundParameters>(1), body, start, settings,
                   [&](const MotionStep& step) {
                     if (landing.time >= 0.0) return;
                     if (step.flight) {
                       ++landing.flight_segments;
                     } else {
                       landing.time = step.begin_time;
                       landing.state = step.begin;
                     }
                   });
  return landing;
}

TEST(FreeFall, TwoMetres) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 4));
  RigidState start;
  start.position = {0.3, -0.2, 2.25};
  const Landing landing = first_landing(terrain, ball(10.0, 0.25), start, 0.64);
  EXPECT_NEAR(landing.time, std::sqrt(2.0 * 2.0 / kTestGravity), 1e-9);
  EXPECT_NEAR(landing.time, 0.63855, 1e-5);
  EXPECT_NEAR(landing.state.velocity.norm(), 6.26418, 1e-5);
}

// The first root of the lowest point's height on the exact flight, by small steps and bisection.
TEST(Landing, TumblingBlocksTouchAtTheRootOfTheExactFlight) {
  const TerrainSurface terrain = ground(plane_mesh(30.0, 20));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const RigidBody body = seed % 2 == 0 ? box(500.0, {1.0, 0.7, 0.4}, 0.01)
                                         : rock(3, {0.45, 0.33, 0.28}, 0.02, 2650.0, seed);
    RigidState start;
    start.position.z() = random.uniform(1.2, 4.0);
    start.orientation = random.rotation();
    start.velocity = random.uniform(0.0, 8.0) * random.unit_vector();
    start.angular_velocity = random.uniform(0.0, 12.0) * random.unit_vector();
    const auto height = [&](double t) {
      return lowest_height(body, free_flight(body, start, t, kTestGravity));
    };
    double clear = 0.0, touching = 0.0;
    while (height(touching) > 0.0) clear = std::exchange(touching, touching + 1e-4);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (clear + touching);
      (height(middle) > 0.0 ? clear : touching) = middle;
    }
    const Landing landing = first_landing(terrain, body, start, touching + 1e-3);
    EXPECT_NEAR(landing.time, touching, 1e-9) << "seed " << seed;
    EXPECT_LT(landing.flight_segments, 150) << "seed " << seed;
  }
}

/// Euler's equations and the attitude's by Runge-Kutta steps of `step` rad, in long double.
Quat stepped(const Vec3& moments, const RigidState& state, double duration, double step) {
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 7, 1>;
  const Vec3 spin = state.orientation.conjugate() * state.angular_velocity;
  Vector y;
  y << spin.cast<Real>(), state.orientation.coeffs().cast<Real>();
  const Eigen::Matrix<Real, 3, 1> j = moments.cast<Real>();
  const auto rate = [&](const Vector& at) {
    const Real wx = at[0], wy = at[1], wz = at[2], x = at[3], yy = at[4], z = at[5], w = at[6];
    Vector d;
    d << (j[1] - j[2]) * wy * wz / j[0], (j[2] - j[0]) * wz * wx / j[1],
        (j[0] - j[1]) * wx * wy / j[2], (w * wx + yy * wz - z * wy) / 2,
        (w * wy + z * wx - x * wz) / 2, (w * wz + x * wy - yy * wx) / 2,
        -(x * wx + yy * wy + z * wz) / 2;
    return d;
  };
  const auto count = static_cast<long>(std::ceil(spin.norm() * std::abs(duration) / step)) + 1;
  const Real h = static_cast<Real>(duration) / count;
  for (long i = 0; i < count; ++i) {
    const Vector k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2),
                 k4 = rate(y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return Quat(static_cast<double>(y[6]), static_cast<double>(y[3]), static_cast<double>(y[4]),
              static_cast<double>(y[5]))
      .normalized();
}

// 1e6 steps of 0.1 ms: 100 s at one turn per second.
TEST(FreeRotation, MiddleAxisTumblingKeepsEnergyMomentumAndAttitude) {
  const RigidBody body = box(100.0, {1.0, 0.7, 0.4});
  RigidState state;
  state.angular_velocity = {0.01, 2.0 * kPi, 0.02};
  const double energy = rotational_energy(body, state);
  const auto momentum = [&](const RigidState& s) {
    return Vec3(s.orientation *
                Vec3(body.moments.cwiseProduct(s.orientation.conjugate() * s.angular_velocity)));
  };
  const Vec3 before = momentum(state);
  for (const double time : {1.0, 20.0, 100.0}) {
    const RigidState after = free_flight(body, state, time, 0.0);
    EXPECT_NEAR(rotational_energy(body, after) / energy, 1.0, 1e-10);
    EXPECT_LT((momentum(after) - before).norm() / before.norm(), 1e-10);
    EXPECT_LT(after.orientation.angularDistance(stepped(body.moments, state, time, 1e-3)), 1e-10)
        << time << " s";
  }
}

/// Which moments are equal, and how the spin lies to the axes.
enum class Kind {
  kGeneral,
  kEqualFirst,
  kEqualLast,
  kNearlyEqual,
  kSphere,
  kPure,
  kNearlyPure,
  kBesideUnstable
};
void PrintTo(Kind kind, std::ostream* out) {
  constexpr std::array kNames = {"general",      "first two equal", "last two equal",
                                 "nearly equal", "sphere",          "pure",
                                 "nearly pure",  "beside unstable"};
  *out << kNames.at(static_cast<std::size_t>(kind));
}

class Attitude : public testing::TestWithParam<Kind> {};

TEST_P(Attitude, IsThatOfFineSteps) {
  const Kind kind = GetParam();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    RigidBody body = box(1.0, Vec3::Ones());
    body.moments = {random.uniform(1.0, 2.0), random.uniform(1.0, 2.0), random.uniform(1.0, 2.0)};
    Vec3& j = body.moments;
    if (kind == Kind::kEqualFirst) j[1] = j[0];
    if (kind == Kind::kEqualLast) j[2] = j[1];
    if (kind == Kind::kNearlyEqual) j[1] = j[0] * (1.0 + 1e-9);
    if (kind == Kind::kSphere) j = Vec3::Constant(1.3);
    const auto axis = static_cast<int>(seed % 3);
    Vec3 spin = 2.0 * random.unit_vector();
    if (kind == Kind::kPure) spin = 2.0 * Vec3::Unit(axis);
    if (kind == Kind::kNearlyPure) spin = 2.0 * Vec3::Unit(axis) + 1e-6 * random.unit_vector();
    if (kind == Kind::kBesideUnstable) spin = 2.0 * Vec3::Unit(axis) + 1e-4 * random.unit_vector();
    RigidState state;
    state.orientation = random.rotation();
    state.angular_velocity = state.orientation * spin;
    const double time = random.uniform(-5.0, 5.0);
    const Quat exact = stepped(j, state, time, 1e-3);
    EXPECT_LT(free_flight(body, state, time, 0.0).orientation.angularDistance(exact), 1e-10)
        << "seed " << seed;
  }
}
INSTANTIATE_TEST_SUITE_P(Bodies, Attitude,
                         testing::Values(Kind::kGeneral, Kind::kEqualFirst, Kind::kEqualLast,
                                         Kind::kNearlyEqual, Kind::kSphere, Kind::kPure,
                                         Kind::kNearlyPure, Kind::kBesideUnstable));

// Across its axis of symmetry a needle or a plate turns steadily: every such axis is a principal
// one. Exactly across, so that nothing along the axis distinguishes the ways of turning.
TEST(FreeRotation, SymmetricBodiesTurnSteadilyAcrossTheirAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double odd : {20.0, 300.0}) {
      RigidBody body = box(100.0, {1.0, 0.7, 0.4});
      body.moments = Vec3::Constant(115.0);
      body.moments[axis] = odd;
      for (int other = 1; other < 3; ++other) {
        RigidState start;
        start.angular_velocity = 5.0 * Vec3::Unit((axis + other) % 3);
        const RigidState end = free_flight(body, start, 2.0, kTestGravity);
        const Quat expected(Eigen::AngleAxisd(10.0, Vec3::Unit((axis + other) % 3)));
        EXPECT_LT(end.orientation.angularDistance(expected), 1e-12) << axis << " " << odd;
        EXPECT_LT((end.angular_velocity - start.angular_velocity).norm(), 1e-12);
      }
    }
  }
}

TEST(FreeRotation, OneLongFlightEqualsManyShortOnes) {
  const RigidBody body = box(100.0, {1.0, 0.7, 0.4});
  RigidState state;
  state.velocity = {3.0, 1.0, 5.0};
  state.angular_velocity = {2.0, 7.0, -1.0};
  RigidState stepped = state;
  for (int i = 0; i < 100; ++i) stepped = free_flight(body, stepped, 0.01, kTestGravity);
  const RigidState whole = free_flight(body, state, 1.0, kTestGravity);
  EXPECT_LT((stepped.position - whole.position).norm(), 1e-12);
  EXPECT_LT(stepped.orientation.angularDistance(whole.orientation), 1e-12);
}

}  // namespace
}  // namespace clast
