/// Damage is what it says, and the same for the same seed.
#include "tests/support/scan_damage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "massprops/solid.hpp"
#include "mesh/mesh_topology.hpp"
#include "tests/app/reliability/cases.hpp"
#include "tests/support/cloud_sample.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

const TriangleMesh& ball() {
  static const TriangleMesh kBall = geodesic_sphere(12);
  return kBall;
}

TEST(ScanDamage, TheShareThatIsAskedForIsLost) {
  Random random(1);
  const double all = static_cast<double>(ball().triangles.size());
  const double left = static_cast<double>(without_faces(ball(), 0.2, random).triangles.size());
  EXPECT_NEAR(left / all, 0.8, 4.0 * std::sqrt(0.16 / all));
  // A triangle stays where its three vertices do.
  const double faces = static_cast<double>(without_vertices(ball(), 0.1, random).triangles.size());
  EXPECT_NEAR(faces / all, 0.9 * 0.9 * 0.9, 0.04);
}

TEST(ScanDamage, ACutTakesTheCapOffABall) {
  // Of a ball of radius 1 a plane at a quarter of the height takes pi h^2 (3 - h) / 3, h = 0.5.
  const TriangleMesh open = cut_off(ball(), Vec3(1, 2, 3).normalized(), 0.25);
  const auto loops = boundary_loops(open);
  ASSERT_EQ(loops.size(), 1u);
  double farthest = -1.0;
  for (const Vec3& v : open.vertices)
    farthest = std::max(farthest, v.dot(Vec3(1, 2, 3).normalized()));
  EXPECT_NEAR(farthest, 0.5, 0.01);
  EXPECT_NEAR(surface_area(open) / surface_area(ball()), 0.75, 0.01);  // Archimedes
}

TEST(ScanDamage, ASideIsACapOfTheBall) {
  // The normals within 60 degrees of a direction are a quarter of the sphere.
  const TriangleMesh open = without_side(ball(), Vec3::UnitX(), kPi / 3.0);
  EXPECT_NEAR(surface_area(open) / surface_area(ball()), 0.75, 0.02);
}

TEST(ScanDamage, AddedPiecesTouchNothing) {
  Random random(2);
  for (const TriangleMesh& mesh :
       {with_bubbles(ball(), 3, 0.1, random), with_islands(ball(), 3, 0.1, random)}) {
    EXPECT_EQ(inspect_mesh(mesh).components, 4u);
  }
  const TriangleMesh bubbles = with_bubbles(ball(), 4, 0.1, random);
  for (std::size_t v = ball().vertices.size(); v < bubbles.vertices.size(); ++v) {
    EXPECT_LT(bubbles.vertices[v].norm(), 1.0);
  }
}

TEST(ScanDamage, JitterMovesByNoMoreThanItsAmplitude) {
  for (const Jitter jitter : {Jitter::kAllWays, Jitter::kAlongNormals, Jitter::kOutward}) {
    Random random(3);
    const TriangleMesh moved = jittered(ball(), jitter, 0.02, random);
    double farthest = 0.0, outward = 0.0;
    for (std::size_t v = 0; v < moved.vertices.size(); ++v) {
      farthest = std::max(farthest, (moved.vertices[v] - ball().vertices[v]).norm());
      outward += moved.vertices[v].norm() - 1.0;
    }
    outward /= static_cast<double>(moved.vertices.size());
    EXPECT_LE(farthest, 0.02 + 1e-12);
    EXPECT_GT(farthest, 0.015);
    EXPECT_NEAR(outward, jitter == Jitter::kOutward ? 0.01 : 0.0, 1e-3);
  }
}

TEST(ScanDamage, ACopyIsAsMuchLargerAsItSays) {
  Random random(4);
  const TriangleMesh both = with_copy(ball(), 1.05, Vec3::Zero(), 10.0, random);
  EXPECT_NEAR(signed_volume(both) / signed_volume(ball()), 1.0 + 1.05 * 1.05 * 1.05, 1e-9);
}

TEST(CloudSample, DensitiesAreWhatTheySay) {
  Random random(5);
  const CloudSample sample{.points = 20000, .density = halved_density(ball(), Vec3::UnitX(), 0.05)};
  std::size_t sparse = 0;
  for (const Vec3& p : sampled_cloud(ball(), sample, random)) sparse += p.x() > 0.0;
  EXPECT_NEAR(static_cast<double>(sparse) / 20000.0, 0.05 / 1.05, 0.006);
}

TEST(ReliabilityCases, AreManyWithNamesOfTheirOwnAndTheSameEachTime) {
  std::vector<reliability::Body> bodies;
  for (int i = 0; i < 30; ++i) {
    const TriangleMesh rock = rock_mesh(13, {0.5, 0.4, 0.3}, 7);
    bodies.push_back({"rock" + std::to_string(i), rock, rock, reliability::truth_of(rock)});
  }
  const std::vector<reliability::Case> cases = reliability::make_cases(bodies);
  EXPECT_GE(cases.size(), 2000u);
  std::set<std::string> names;
  for (const reliability::Case& one : cases) names.insert(one.name());
  EXPECT_EQ(names.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); i += bodies.size()) {  // one of each kind and amount
    const reliability::DamagedScan first = cases[i].scan(), again = cases[i].scan();
    ASSERT_EQ(first.surface.vertices.size(), again.surface.vertices.size()) << cases[i].name();
    for (std::size_t v = 0; v < first.surface.vertices.size(); ++v) {
      ASSERT_EQ(first.surface.vertices[v], again.surface.vertices[v]) << cases[i].name();
    }
    EXPECT_FALSE(first.expected.empty());
  }
}

}  // namespace
}  // namespace clast
