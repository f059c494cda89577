#include "massprops/sphero.hpp"
#include "massprops/principal_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/error.hpp"
#include "massprops/solid.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

const Pose kMotion{Vec3(10.0, -4.0, 5.0), Quat(0.5, -0.3, 0.7, 0.2).normalized()};

double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  return (x - a - std::clamp((x - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab).norm();
}

double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a).normalized();
  const bool above = (b - a).cross(x - a).dot(n) >= 0.0 && (c - b).cross(x - b).dot(n) >= 0.0 &&
                     (a - c).cross(x - c).dot(n) >= 0.0;
  if (above) return std::abs((x - a).dot(n));
  return std::min(
      {distance_to_segment(x, a, b), distance_to_segment(x, b, c), distance_to_segment(x, c, a)});
}

/// Inside the core by its winding number, or within `radius` of a triangle: by definition of the
/// body.
bool body_holds(const TriangleMesh& core, double radius, const Vec3& x) {
  double solid_angle = 0.0;
  for (const auto& [i, j, k] : core.triangles) {
    const Vec3& p = core.vertices[i];
    const Vec3& q = core.vertices[j];
    const Vec3& s = core.vertices[k];
    if (distance_to_triangle(x, p, q, s) <= radius) return true;
    const Vec3 a = (p - x).normalized(), b = (q - x).normalized(), c = (s - x).normalized();
    solid_angle += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return solid_angle > 2.0 * kPi;
}

/// The unit cube with a cut of no width from the middle of its top to its centre.
TriangleMesh slit_cube() {
  TriangleMesh mesh;
  for (const double y : {0.0, 1.0}) {
    for (const auto& [x, z] : {std::pair(0.0, 0.0),
                               {1.0, 0.0},
                               {1.0, 1.0},
                               {0.5, 1.0},
                               {0.5, 0.5},
                               {0.5, 1.0},
                               {0.0, 1.0}}) {
      mesh.vertices.emplace_back(x, y, z);
    }
  }
  const std::array<TriangleMesh::Triangle, 5> front = {
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {4, 5, 6}, {4, 6, 0}}};
  for (const auto& [a, b, c] : front) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a + 7, c + 7, b + 7});
  }
  for (std::uint32_t i = 0; i < 7; ++i) {
    const std::uint32_t j = (i + 1) % 7;
    mesh.triangles.push_back({i, i + 7, j + 7});
    mesh.triangles.push_back({i, j + 7, j});
  }
  return mesh;
}

TEST(SpheroMass, FacesThatLieOnEachOtherAreNoObstacle) {
  for (const Quat& turn : {Quat::Identity(), kMotion.rotation, Quat(0.8, 0.0, 0.6, 0.0)}) {
    const SpheroPolyhedron body =
        transformed(make_sphero_polyhedron(slit_cube(), 0.0), {Vec3::Zero(), turn});
    const MassProperties p = sphero_mass_properties(body, 1.0);
    EXPECT_NEAR(p.volume, 1.0, 1e-12);
    EXPECT_LT((p.inertia - Mat3::Identity() / 6.0).norm(), 1e-12);
  }
}

TEST(SpheroMass, SpheroCubeMatchesItsFormula) {
  TriangleMesh cube = box_mesh(Vec3::Ones());
  const SpheroPolyhedron body = transformed(make_sphero_polyhedron(cube, 0.2), kMotion);
  for (const MassProperties& p :
       {convex_sphero_mass_properties(body, 1.0), sphero_mass_properties(body, 1.0)}) {
    EXPECT_NEAR(p.volume / 2.6105014400690667, 1.0, 1e-12);
    EXPECT_LT((p.inertia / p.volume - 0.309245342893335 * Mat3::Identity()).norm(), 1e-12);
    EXPECT_LT((p.centre - kMotion * Vec3::Constant(0.5)).norm(), 1e-12);
    EXPECT_EQ(p.relative_error, 0.0);
  }
}

TEST(SpheroMass, FinerTrianglesOfTheSameCubeChangeNothing) {
  const SpheroPolyhedron body =
      transformed(make_sphero_polyhedron(box_mesh(Vec3::Ones(), 4), 0.2), kMotion);
  const MassProperties p = sphero_mass_properties(body, 1.0);
  EXPECT_NEAR(p.volume / 2.6105014400690667, 1.0, 1e-12);
  EXPECT_LT((p.inertia / p.volume - 0.309245342893335 * Mat3::Identity()).norm(), 1e-12);
}

TEST(SpheroMass, AFaceWithARepeatedVertexChangesNothing) {
  const SpheroPolyhedron body = make_sphero_polyhedron(box_mesh(Vec3::Ones()), 0.2);
  SpheroPolyhedron repeated = body;
  const auto [a, b] = body.edges.front();
  repeated.faces.push_back({a, a, b});
  const MassProperties p = sphero_mass_properties(repeated, 1.0);
  EXPECT_EQ(p.volume, sphero_mass_properties(body, 1.0).volume);
  EXPECT_EQ(p.relative_error, 0.0);
}

TEST(SpheroMass, BallAndCapsuleAreClosedForms) {
  SpheroPolyhedron ball;
  ball.vertices = {{1.0, 2.0, 3.0}};
  ball.radius = 0.5;
  const MassProperties b = sphero_mass_properties(ball, 2000.0);
  EXPECT_NEAR(b.volume, kPi / 6.0, 1e-15);
  EXPECT_TRUE(b.inertia.isApprox(0.4 * b.mass * 0.25 * Mat3::Identity(), 1e-14));
  EXPECT_NEAR(sphero_surface_area(ball), kPi, 1e-14);

  // Textbook capsule: cylinder m_c of height h, two half balls of mass m_b / 2 each.
  SpheroPolyhedron capsule;
  const double r = 0.3, h = 1.7;
  capsule.vertices = {{0, 0, 0}, {0, 0, h}};
  capsule.edges = {{0, 1}};
  capsule.radius = r;
  const MassProperties c = sphero_mass_properties(capsule, 1.0);
  const double tube = kPi * r * r * h, caps = 4.0 / 3.0 * kPi * r * r * r;
  EXPECT_NEAR(c.volume, tube + caps, 1e-14);
  EXPECT_NEAR(c.inertia(2, 2), tube * r * r / 2.0 + caps * 0.4 * r * r, 1e-14);
  EXPECT_NEAR(
      c.inertia(0, 0),
      tube * (h * h / 12.0 + r * r / 4.0) + caps * (0.4 * r * r + h * h / 4.0 + 3.0 * h * r / 8.0),
      1e-14);
  EXPECT_NEAR(sphero_surface_area(capsule), 4.0 * kPi * r * r + 2.0 * kPi * r * h, 1e-14);
}

class LBlock : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(LBlock, TrueErrorIsInsideTheStatedOne) {
  const auto [radius, accuracy] = GetParam();
  const SpheroPolyhedron body = transformed(make_sphero_polyhedron(l_block(), radius), kMotion);
  const MassProperties p = sphero_mass_properties(body, 1.0, accuracy);
  EXPECT_LE(p.relative_error, accuracy);
  EXPECT_GT(p.relative_error, 0.0);
  EXPECT_NEAR(p.volume / l_block_volume(radius), 1.0, p.relative_error);
  // By symmetry of the L the centre lies on its diagonal at half height.
  const Vec3 centre = kMotion.inverse() * p.centre;
  EXPECT_NEAR(centre.x(), centre.y(), 2.0 * accuracy);
  EXPECT_NEAR(centre.z(), 0.5, 2.0 * accuracy);
}

INSTANTIATE_TEST_SUITE_P(RadiiAndAccuracies, LBlock,
                         testing::Combine(testing::Values(0.05, 0.2, 0.5, 0.9, 1.0),
                                          testing::Values(1e-3, 1e-4, 1e-5, 1e-6)));

TEST(SpheroMass, LBlockVolumeWithinAMillionth) {
  for (const double radius : {0.05, 0.2}) {
    const MassProperties p =
        sphero_mass_properties(make_sphero_polyhedron(l_block(), radius), 1.0, 1e-6);
    EXPECT_NEAR(p.volume / l_block_volume(radius), 1.0, 1e-6);
  }
}

// Between two facing unit cubes a gap g apart the skins overlap in a lens whose section at height s
// is a square swept by a disc of radius sqrt(r^2 - s^2).
TEST(SpheroMass, SkinsThatMeetAcrossAGapCountOnce) {
  const double g = 0.15, r = 0.1;
  TriangleMesh other = box_mesh(Vec3::Ones());
  for (Vec3& v : other.vertices) v.x() += 1.0 + g;
  const TriangleMesh pair = merged(box_mesh(Vec3::Ones()), other);
  const double cube = 1.0 + 6.0 * r + 3.0 * kPi * r * r + 4.0 / 3.0 * kPi * r * r * r;
  const double s = 0.5 * g;
  const double strip = 0.5 * (r * r * std::acos(s / r) - s * std::sqrt(r * r - s * s));
  const double cap = kPi * (r * r * (r - s) - (r * r * r - s * s * s) / 3.0);
  const double expected = 2.0 * cube - 2.0 * ((r - s) + 4.0 * strip + cap);
  const MassProperties p =
      sphero_mass_properties(transformed(make_sphero_polyhedron(pair, r), kMotion), 1.0, 1e-5);
  EXPECT_GT(p.relative_error, 0.0);
  EXPECT_NEAR(p.volume / expected, 1.0, std::max(p.relative_error, 1e-9));
  EXPECT_THROW(convex_sphero_mass_properties(make_sphero_polyhedron(pair, r), 1.0), GeometryError);
}

TEST(SpheroMass, CoreThatCrossesItselfCountsOnce) {
  TriangleMesh other = box_mesh(Vec3::Ones());
  for (Vec3& v : other.vertices) v.x() += 0.5;
  const TriangleMesh crossing = merged(box_mesh(Vec3::Ones()), other);
  const double r = 0.1;
  const MassProperties whole =
      sphero_mass_properties(make_sphero_polyhedron(box_mesh(Vec3(1.5, 1, 1)), r), 1.0);
  const MassProperties p = sphero_mass_properties(make_sphero_polyhedron(crossing, r), 1.0, 1e-4);
  EXPECT_LE(p.relative_error, 1e-4);
  EXPECT_NEAR(p.volume / whole.volume, 1.0, p.relative_error);
  EXPECT_LT((p.inertia - whole.inertia).norm(), p.relative_error * whole.inertia(0, 0));
}

/// A unit cube with a cubic cavity of side `c` about `middle`.
TriangleMesh hollow_cube(double c, const Vec3& middle) {
  TriangleMesh cavity = box_mesh(Vec3::Constant(c));
  for (auto& t : cavity.triangles) std::swap(t[0], t[1]);
  for (Vec3& v : cavity.vertices) v += middle - Vec3::Constant(0.5 * c);
  return merged(box_mesh(Vec3::Ones()), cavity);
}

// Rounding by r shrinks a cavity by r on every side, to a sharp cube of side c - 2 r, and fills it
// from r = c / 2 on. The rest is the sphero-cube: V and J/V in closed form for r = 0.2.
class HollowCube : public testing::TestWithParam<double> {};

TEST_P(HollowCube, CavityShrinksByTheRadius) {
  const double c = GetParam(), r = 0.2, left = std::max(c - 2.0 * r, 0.0);
  const Vec3 middle(0.47, 0.5, 0.52);
  const SpheroPolyhedron body =
      transformed(make_sphero_polyhedron(hollow_cube(c, middle), r), kMotion);
  const double outer = 2.6105014400690667, void_volume = left * left * left;
  const double volume = outer - void_volume;
  const Vec3 centre = (outer * Vec3::Constant(0.5) - void_volume * middle) / volume;
  const auto about_centre = [&](double v, double j, const Vec3& place) {
    const Vec3 d = place - centre;
    return Mat3(v *
                (j * Mat3::Identity() + d.squaredNorm() * Mat3::Identity() - d * d.transpose()));
  };
  const Mat3 inertia = about_centre(outer, 0.309245342893335, Vec3::Constant(0.5)) -
                       about_centre(void_volume, left * left / 6.0, middle);
  const MassProperties p = sphero_mass_properties(body, 1.0, 1e-5);
  EXPECT_LE(p.relative_error, 1e-5);
  EXPECT_NEAR(p.volume / volume, 1.0, p.relative_error);
  EXPECT_LT((p.centre - kMotion * centre).norm(), p.relative_error);
  const Mat3 turn = kMotion.rotation.toRotationMatrix();
  EXPECT_LT((p.inertia - turn * inertia * turn.transpose()).norm(),
            p.relative_error * principal_frame(p).moments[0]);
  EXPECT_THROW(convex_sphero_mass_properties(body, 1.0), GeometryError);
}

INSTANTIATE_TEST_SUITE_P(WideToFilled, HollowCube, testing::Values(0.9, 0.6, 0.45, 0.4, 0.3));

/// Steiner-type estimate with reflex correction, for a core of genus 0.
double steiner_estimate(const TriangleMesh& core, double r) {
  std::map<std::array<std::uint32_t, 2>, Vec3> left;  ///< normal of the face that owns an edge
  double area = 0.0, edges = 0.0;
  for (const auto& t : core.triangles) {
    const Vec3 normal = (core.vertices[t[1]] - core.vertices[t[0]])
                            .cross(core.vertices[t[2]] - core.vertices[t[0]]);
    area += 0.5 * normal.norm();
    for (int i = 0; i < 3; ++i) left[{t[i], t[(i + 1) % 3]}] = normal.normalized();
  }
  for (const auto& [edge, normal] : left) {
    if (edge[0] > edge[1]) continue;
    const Vec3& other = left.at({edge[1], edge[0]});
    const Vec3 along = core.vertices[edge[1]] - core.vertices[edge[0]];
    const double bend = std::atan2(along.normalized().dot(normal.cross(other)), normal.dot(other));
    edges += along.norm() * (bend > 0.0 ? 0.5 * bend : -std::tan(0.5 * std::abs(bend)));
  }
  return enclosed_volume(core) + area * r + edges * r * r + 4.0 / 3.0 * kPi * r * r * r;
}

// The estimate leaves out what pieces do to each other at vertices, of third order in r and in the
// bends of the edges there: little on a gently bumpy rock, whose reflex term is 1.0 r^2 m^3.
TEST(SpheroMass, ABumpyRockHasTheSteinerEstimate) {
  const TriangleMesh core = rock_mesh(5, {1.0, 0.8, 0.6}, 4);
  for (const double r : {0.04, 0.02, 0.01}) {
    const MassProperties p = sphero_mass_properties(make_sphero_polyhedron(core, r), 1.0, 1e-6);
    EXPECT_GT(p.relative_error, 0.0);
    EXPECT_NEAR(p.volume, steiner_estimate(core, r), p.relative_error * p.volume + 0.1 * r * r * r);
  }
}

TEST(SpheroMass, SteinerEstimateOfTheLBlockIsExactButForTheEndsOfItsReflexEdge) {
  for (const double r : {0.05, 0.2}) {
    EXPECT_NEAR(steiner_estimate(l_block(), r) - l_block_volume(r),
                4.0 / 3.0 * kPi * r * r * r - 4.0 / 3.0 * (5.0 * kPi / 4.0 - 1.0) * r * r * r,
                1e-13);
  }
}

class RoughRock : public testing::TestWithParam<unsigned> {};

TEST_P(RoughRock, AgreesWithMonteCarlo) {
  Random random(100 + GetParam());
  const TriangleMesh core = random_rock(GetParam(), 2, 0.35);
  const double r = random.uniform(0.02, 0.25);
  const MassProperties p = sphero_mass_properties(make_sphero_polyhedron(core, r), 1.0, 1e-4);
  EXPECT_LE(p.relative_error, 1e-4);

  Bounds box = bounds(core);
  const Vec3 low = box.low - Vec3::Constant(r), size = box.high - box.low + Vec3::Constant(2 * r);
  const int count = 40000;
  int hits = 0;
  Vec3 sum = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec3 share(random.uniform(), random.uniform(), random.uniform());
    const Vec3 x = low + share.cwiseProduct(size);
    if (!body_holds(core, r, x)) continue;
    ++hits;
    sum += x;
    second += x * x.transpose();
  }
  const double share = double(hits) / count;
  const double five_sigma = 5.0 * std::sqrt(share * (1.0 - share) / count) / share;
  EXPECT_NEAR(share * size.prod() / p.volume, 1.0, five_sigma);
  const Mat3 spread = second / hits - (sum / hits) * (sum / hits).transpose();
  const Mat3 inertia = spread.trace() * Mat3::Identity() - spread;
  EXPECT_TRUE(inertia.isApprox(p.inertia / p.mass, 2.5 * five_sigma));
}

TEST_P(RoughRock, TrueErrorIsInsideTheStatedOneAndTurnsWithTheBody) {
  const TriangleMesh core = random_rock(GetParam(), 3, 0.25);
  const SpheroPolyhedron body = make_sphero_polyhedron(core, 0.04);
  const MassProperties fine = sphero_mass_properties(body, 1.0, 1e-5);
  for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
    const MassProperties p = sphero_mass_properties(transformed(body, kMotion), 1.0, accuracy);
    EXPECT_LE(p.relative_error, accuracy);
    const double bound = p.relative_error + fine.relative_error;
    EXPECT_NEAR(p.volume / fine.volume, 1.0, bound);
    const Mat3 turn = kMotion.rotation.toRotationMatrix();
    EXPECT_LT((p.inertia - turn * fine.inertia * turn.transpose()).norm(),
              bound * principal_frame(fine).moments[0]);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RoughRock, testing::Range(0u, 8u));

// A shallow dent on one face, with reflex edges far shorter than the columns are apart: unless a
// column meets it, only the allowance for the unseen covers it.
TEST(SpheroMass, WhatColumnsMayMissIsAllowedFor) {
  const double r = 0.02, side = 1e-3, depth = 5e-4;
  TriangleMesh dented = box_mesh(Vec3::Ones());
  // The face z = 1 is cut by its diagonal from (0, 0, 1) to (1, 1, 1); a pyramid goes in beside it.
  const auto vertex = [&](double x, double y, double z) {
    dented.vertices.emplace_back(x, y, z);
    return static_cast<std::uint32_t>(dented.vertices.size() - 1);
  };
  std::erase_if(dented.triangles, [&](const TriangleMesh::Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return dented.vertices[v].z() == 1.0; });
  });
  const auto corner = [&](double x, double y) {
    const auto found = std::find(dented.vertices.begin(), dented.vertices.end(), Vec3(x, y, 1));
    return static_cast<std::uint32_t>(found - dented.vertices.begin());
  };
  const std::array<std::uint32_t, 4> outer = {corner(0, 0), corner(1, 0), corner(1, 1),
                                              corner(0, 1)};
  const std::array<std::uint32_t, 4> rim = {vertex(0.3, 0.4, 1), vertex(0.3 + side, 0.4, 1),
                                            vertex(0.3 + side, 0.4 + side, 1),
                                            vertex(0.3, 0.4 + side, 1)};
  const std::uint32_t bottom = vertex(0.3 + 0.5 * side, 0.4 + 0.5 * side, 1 - depth);
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    dented.triangles.push_back({outer[i], outer[j], rim[j]});
    dented.triangles.push_back({outer[i], rim[j], rim[i]});
    dented.triangles.push_back({rim[i], rim[j], bottom});
  }
  // No ball of that radius gets into the dent: the body lies between that of the cube and what the
  // ball leaves of the rim, at most the dent itself lower.
  const double cube = 1.0 + 6.0 * r + 3.0 * kPi * r * r + 4.0 / 3.0 * kPi * r * r * r;
  for (const double accuracy : {1e-2, 1e-4, 1e-5}) {
    const MassProperties p =
        sphero_mass_properties(make_sphero_polyhedron(dented, r), 1.0, accuracy);
    EXPECT_GT(p.relative_error, 0.0);
    EXPECT_LE(p.relative_error, accuracy);
    EXPECT_NEAR(p.volume / cube, 1.0, p.relative_error + side * side * depth / 3.0);
  }
}

TEST(SpheroMass, ZeroRadiusIsTheCoreItself) {
  const TriangleMesh core = random_rock(3, 2, 0.3);
  const MassProperties solid = solid_mass_properties(core, 2650.0);
  const MassProperties p = sphero_mass_properties(make_sphero_polyhedron(core, 0.0), 2650.0);
  EXPECT_NEAR(p.volume / solid.volume, 1.0, 1e-12);
  EXPECT_TRUE(p.inertia.isApprox(solid.inertia, 1e-12));
}

TEST(SpheroMass, SameBitsEveryTime) {
  const SpheroPolyhedron body = make_sphero_polyhedron(random_rock(9, 3, 0.3), 0.05);
  const MassProperties first = sphero_mass_properties(body, 2650.0);
  const MassProperties again = sphero_mass_properties(body, 2650.0);
  EXPECT_EQ(first.volume, again.volume);
  EXPECT_TRUE(first.inertia == again.inertia);
}

TEST(SpheroArea, ConvexIsSteinersFormula) {
  const double r = 0.2;
  const double cube = 6.0 + 2.0 * 3.0 * kPi * r + 4.0 * kPi * r * r;
  EXPECT_NEAR(sphero_surface_area(
                  transformed(make_sphero_polyhedron(box_mesh(Vec3::Ones(), 2), r), kMotion)),
              cube, 1e-12);
}

TEST(SpheroArea, LBlockIsTheDerivativeOfItsVolume) {
  for (const double r : {0.05, 0.2, 0.5}) {
    const double exact =
        14.0 + 2.0 * (21.0 * kPi / 4.0 - 1.0) * r + 4.0 * (5.0 * kPi / 4.0 - 1.0) * r * r;
    EXPECT_NEAR(sphero_surface_area(make_sphero_polyhedron(l_block(), r)) / exact, 1.0, 1e-3);
  }
}

TEST(SpheroMass, WhatBoundsNoSolidIsRefused) {
  TriangleMesh open = box_mesh(Vec3::Ones());
  open.triangles.pop_back();
  EXPECT_THROW(sphero_mass_properties(make_sphero_polyhedron(open, 0.1), 1.0), GeometryError);
  EXPECT_THROW(sphero_surface_area(make_sphero_polyhedron(open, 0.1)), GeometryError);
  TriangleMesh inward = box_mesh(Vec3::Ones());
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_THROW(sphero_mass_properties(make_sphero_polyhedron(inward, 0.1), 1.0), GeometryError);
  EXPECT_THROW(convex_sphero_mass_properties(make_sphero_polyhedron(l_block(), 0.1), 1.0),
               GeometryError);
  SpheroPolyhedron two_points;
  two_points.vertices = {{0, 0, 0}, {1, 0, 0}};
  two_points.radius = 0.1;
  EXPECT_THROW(sphero_mass_properties(two_points, 1.0), GeometryError);
  two_points.edges = {{0, 1}};
  two_points.radius = 0.0;
  EXPECT_THROW(sphero_mass_properties(two_points, 1.0), GeometryError);
}

TEST(SpheroMass, OptionsOutOfRangeAreRefused) {
  SpheroPolyhedron cube = make_sphero_polyhedron(box_mesh(Vec3::Ones()), 0.1);
  EXPECT_THROW(sphero_mass_properties(cube, -1.0), InputError);
  EXPECT_THROW(sphero_mass_properties(cube, 1.0, 0.0), InputError);
  EXPECT_THROW(sphero_mass_properties(cube, 1.0, 0.5), InputError);
  cube.radius = -0.1;
  EXPECT_THROW(sphero_mass_properties(cube, 1.0), InputError);
  cube.radius = std::nan("");
  EXPECT_THROW(sphero_surface_area(cube), InputError);
}

}  // namespace
}  // namespace clast
