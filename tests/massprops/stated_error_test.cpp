/// The true error of volume and inertia stays inside the stated one, whatever the orientation.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

constexpr double kAccuracy = 1e-3;

/// The body turned at random and measured coarsely against `volume`, and against the inertia of a
/// measurement twenty times finer in another orientation.
void expect_inside(const SpheroPolyhedron& body, const double* volume, Random& random) {
  const MassProperties fine = sphero_mass_properties(body, 1.0, kAccuracy / 20.0);
  const Pose motion{Vec3(1.0, 2.0, 3.0), random.rotation()};
  const MassProperties p = sphero_mass_properties(transformed(body, motion), 1.0, kAccuracy);
  const Mat3 turn = motion.rotation.toRotationMatrix();
  EXPECT_LE(p.relative_error, kAccuracy);
  const double rounding = 1e-12;
  const double bound = p.relative_error + (volume ? 0.0 : fine.relative_error) + rounding;
  EXPECT_NEAR(p.volume / (volume ? *volume : fine.volume), 1.0, bound);
  EXPECT_LE((p.inertia - turn * fine.inertia * turn.transpose()).norm(),
            (p.relative_error + fine.relative_error + rounding) * principal_frame(fine).moments[0]);
}

TEST(StatedError, HoldsForLBlocksInAnyOrientation) {
  Random random(11);
  for (int i = 0; i < 150; ++i) {
    const double r = random.uniform(0.02, 1.0);
    SCOPED_TRACE("L " + std::to_string(i) + ", r = " + std::to_string(r));
    const double volume = l_block_volume(r);
    expect_inside(make_sphero_polyhedron(l_block(), r), &volume, random);
  }
}

TEST(StatedError, HoldsForRoughRocksInAnyOrientation) {
  Random random(12);
  for (unsigned i = 0; i < 100; ++i) {
    const TriangleMesh core =
        rough_rock_mesh(i % 2 == 0 ? 3 : 6, {0.42, 0.36, 0.30}, i + 1, random.uniform(0.0, 0.4));
    SCOPED_TRACE("rock " + std::to_string(i));
    expect_inside(make_sphero_polyhedron(core, random.uniform(0.005, 0.1)), nullptr, random);
  }
}

}  // namespace
}  // namespace clast
