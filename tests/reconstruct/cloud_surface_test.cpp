#include "reconstruct/cloud/cloud_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"
#include "massprops/solid.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/cloud_normals.hpp"
#include "reconstruct/cloud/detail/poisson.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "tests/support/field_scene.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/sampled_cloud.hpp"

namespace clast {
namespace {

constexpr CloudSurfaceOptions kCoarse{.averaging_cell = 0.02};  // 5,000 averaged points: fast

/// Points on a body, without those that face down by more than `steepest`.
std::vector<Vec3> points_on(TriangleMesh body, double steepest, int count = 20000) {
  for (Vec3& v : body.vertices) v.z() += 5.0;
  const FieldGround nothing(0.0, 0.0, 0, 1.0, 1);
  const double noise = 0.001 * bounds(body).diagonal();
  return field_scene({body}, nothing,
                     {.per_block = count, .ground = 0, .noise = noise, .steepest = steepest}, 2)
      .points;
}

TEST(CloudSurface, OfABallSeenFromAllSidesIsTheBall) {
  const TriangleMesh surface =
      fit_cloud_surface(points_on(geodesic_sphere(20), -1.0), kCoarse).mesh;
  const MeshReport report = inspect_mesh(surface);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_NEAR(solid_mass_properties(surface, 1.0).volume, 4.0 / 3.0 * kPi, 0.015 * 4.2);
}

TEST(CloudSurface, OfAConcaveRockHasItsVolume) {
  const TriangleMesh rock = rock_mesh(16, {0.5, 0.4, 0.3}, 3);
  const TriangleMesh surface = fit_cloud_surface(points_on(rock, -1.0), kCoarse).mesh;
  const double truth = solid_mass_properties(rock, 1.0).volume;
  EXPECT_NEAR(solid_mass_properties(surface, 1.0).volume, truth, 0.015 * truth);
}

TEST(CloudSurface, IsOpenWhereNoPointsAre) {
  // A cap within acos 0.6 = 53 degrees of the lowest point has a fifth of the ball.
  const TriangleMesh surface =
      fit_cloud_surface(points_on(geodesic_sphere(20), -0.6), kCoarse).mesh;
  const MeshReport report = inspect_mesh(surface);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.boundary_loops, 1u);
  EXPECT_TRUE(report.is_oriented());
  // It goes on for up to 1.5 cells of 0.07 around a rim of 2 pi 0.8.
  EXPECT_NEAR(surface_area(surface), 0.8 * 4.0 * kPi, 0.06 * 4.0 * kPi);
  EXPECT_NEAR(bounds(surface).low.z(), 5.0 - 0.6, 0.15);
}

// Points on a grid have many equal distances: what decides between cells of equal quality must not
// be where they lie in memory.
TEST(CloudSurface, IndicatorIsTheSameWhereverMemoryLies) {
  std::vector<Vec3> points, normals;
  constexpr int kSide = 32;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < kSide; ++i) {
        for (int k = 0; k < kSide; ++k) {
          Vec3 position(side, (2.0 * i + 1.0) / kSide - 1.0, (2.0 * k + 1.0) / kSide - 1.0);
          Vec3 normal(side, 0.0, 0.0);
          std::rotate(position.begin(), position.begin() + axis, position.end());
          std::rotate(normal.begin(), normal.begin() + axis, normal.end());
          points.push_back(position);
          normals.push_back(normal);
        }
      }
    }
  }
  Random random(1);
  std::vector<std::unique_ptr<char[]>> held;
  std::set<double> values;
  for (int run = 0; run < 8; ++run) {
    for (std::uint64_t n = random.uniform_index(2000); n > 0; --n) {
      held.push_back(
          std::make_unique<char[]>(1 + random.uniform_index(run % 2 == 0 ? 500 : 50000)));
      if (random.uniform_index(3) == 0) held[random.uniform_index(held.size())].reset();
    }
    const reconstruct_detail::IndicatorFunction indicator(points, normals);
    ASSERT_TRUE(indicator.is_solved());
    values.insert(indicator.value_at({0.31, 0.17, 0.44}));
  }
  EXPECT_EQ(values.size(), 1u);
}

TEST(CloudSurface, LiesWhereTheCloudLiesOnAMap) {
  std::vector<Vec3> points = points_on(geodesic_sphere(10), -1.0, 10000);
  const TriangleMesh here = fit_cloud_surface(points, kCoarse).mesh;
  for (Vec3& p : points) p += Vec3(524288.0, 4194304.0, 1024.0);  // exact in a float of the offset
  const TriangleMesh there = fit_cloud_surface(points, kCoarse).mesh;
  EXPECT_NEAR(solid_mass_properties(there, 1.0).volume, solid_mass_properties(here, 1.0).volume,
              0.002);
  EXPECT_LT((bounds(there).low - bounds(here).low - Vec3(524288.0, 4194304.0, 1024.0)).norm(),
            0.01);
}

// Where new vertices come to lie in memory follows from what was done before.
TEST(CloudSurface, SameInputGivesTheSameBitsWhateverWasDoneBefore) {
  const std::vector<Vec3> points = points_on(rock_mesh(16, {0.5, 0.4, 0.3}, 3), -0.6, 40000);
  const CloudSurfaceOptions options{.averaging_cell = 0.012};
  const TriangleMesh first = fit_cloud_surface(points, options).mesh;
  for (const double cell : {0.02, 0.015, 0.03}) {
    fit_cloud_surface(points, {.averaging_cell = cell});
    const TriangleMesh again = fit_cloud_surface(points, options).mesh;
    EXPECT_EQ(first.vertices, again.vertices) << cell;
    EXPECT_EQ(first.triangles, again.triangles) << cell;
  }
}

TEST(CloudSurface, OfPointsWithoutNoiseGoesThroughThemAndNeverBeyond) {
  const TriangleMesh rock = rock_mesh(16, {0.5, 0.4, 0.05}, 3);
  const std::vector<Vec3> points = sampled_cloud(rock, {.points = 6000}, 4);
  const CloudSurface surface = fit_cloud_surface(points);
  EXPECT_TRUE(inspect_mesh(surface.mesh).is_closed());
  EXPECT_EQ(surface.gaps, 0u);
  std::set<std::array<double, 3>> given;
  for (const Vec3& p : points) given.insert({p.x(), p.y(), p.z()});
  std::size_t on = 0;
  for (const Vec3& v : surface.mesh.vertices) on += given.contains({v.x(), v.y(), v.z()});
  EXPECT_EQ(on, surface.mesh.vertices.size());
  const double truth = solid_mass_properties(rock, 1.0).volume;
  EXPECT_NEAR(solid_mass_properties(surface.mesh, 1.0).volume, truth, 0.01 * truth);
}

TEST(CloudSurface, IsClosedWhereTheDensityOnlyFalls) {
  const std::vector<Vec3> points =
      sampled_cloud(geodesic_sphere(20), {.points = 8000, .fall = 0.05, .step = true}, 5);
  const CloudSurface surface = fit_cloud_surface(points);
  EXPECT_TRUE(inspect_mesh(surface.mesh).is_closed());
  EXPECT_NEAR(solid_mass_properties(surface.mesh, 1.0).volume, 4.0 / 3.0 * kPi, 0.02 * 4.2);
}

TEST(CloudSurface, AGapIsFilledAndReportedWithItsPlace) {
  std::vector<Vec3> points = sampled_cloud(geodesic_sphere(20), {.points = 20000}, 6);
  std::erase_if(points,
                [](const Vec3& p) { return p.z() > std::cos(0.12); });  // 0.36 % of the area
  const CloudSurface surface = fit_cloud_surface(points);
  EXPECT_TRUE(inspect_mesh(surface.mesh).is_closed());
  EXPECT_EQ(surface.gaps, 1u);
  EXPECT_NEAR(surface.gap_fraction, 0.0036, 0.002);
  EXPECT_GT(surface.gap_position.z(), 0.9);
}

// No point lies on the strip between the two rims of a thin edge, which is hardly wider than the
// points are apart anyway.
TEST(CloudSurface, TheMissingEdgeOfALensIsUnseen) {
  TriangleMesh lens = geodesic_sphere(24);
  for (Vec3& v : lens.vertices) v = v.cwiseProduct(Vec3(0.5, 0.5, 0.06));
  std::vector<Vec3> points = sampled_cloud(lens, {.points = 8000}, 8);
  EXPECT_TRUE(inspect_mesh(fit_cloud_surface(points).mesh).is_closed());
  std::erase_if(points, [](const Vec3& p) { return p.x() < -0.43; });
  const CloudSurface surface = fit_cloud_surface(points);
  EXPECT_TRUE(surface.gaps == 1 || !inspect_mesh(surface.mesh).is_closed());
  if (surface.gaps == 1) {
    EXPECT_LT(surface.gap_position.x(), -0.44);
  }
}

/// Root mean square distance of the points of a surface from `truth`, m.
double roughness(const TriangleMesh& surface, const TriangleMesh& truth) {
  const TriangleTree tree(truth);
  double squares = 0.0;
  for (const Vec3& v : surface.vertices) squares += tree.closest_point(v).squared_distance;
  return std::sqrt(squares / static_cast<double>(surface.vertices.size()));
}

TEST(CloudSurface, LargeNoiseIsSmoothedWhateverTheDensity) {
  const TriangleMesh rock = rock_mesh(16, {0.5, 0.4, 0.3}, 3);
  const double truth = solid_mass_properties(rock, 1.0).volume;
  for (const std::size_t count : {6000u, 20000u}) {
    for (const double noise : {0.003, 0.005}) {  // 0.3 and 0.5 % of L
      SCOPED_TRACE(std::to_string(count) + " points, noise " + std::to_string(noise));
      const CloudSurface cloud =
          fit_cloud_surface(sampled_cloud(rock, {.points = count, .noise = noise}, 5));
      EXPECT_NEAR(signed_volume(cloud.mesh), truth, 0.01 * truth);
      EXPECT_LT(roughness(cloud.mesh, rock), 0.5 * noise);
      EXPECT_LT(cloud.mesh.vertices.size(), count);
      EXPECT_GE(cloud.uncertainty.extent_error, noise) << "the noise is not forgotten";
    }
  }
}

TEST(CloudSurface, CurvatureAndThicknessAreNoNoise) {
  // Points as far apart as the plate is thick scatter about any plane through them.
  const TriangleMesh plate = rock_mesh(16, {0.5, 0.4, 0.03}, 3);
  const CloudSurface of_plate = fit_cloud_surface(sampled_cloud(plate, {.points = 3000}, 4));
  const double truth = solid_mass_properties(plate, 1.0).volume;
  EXPECT_NEAR(signed_volume(of_plate.mesh), truth, 0.08 * truth) << "it keeps both faces";
  EXPECT_GE(of_plate.mesh.vertices.size() + of_plate.outliers, 3000u) << "no point was averaged";
  const TriangleMesh coarse = rock_mesh(16, {0.5, 0.4, 0.3}, 3);
  const CloudSurface of_few = fit_cloud_surface(sampled_cloud(coarse, {.points = 1000}, 4));
  EXPECT_GE(of_few.mesh.vertices.size() + of_few.outliers, 1000u);
}

TEST(CloudSurface, PointsTooFarApartForAThinBodyAreRefused) {
  const TriangleMesh plate = rock_mesh(16, {0.5, 0.4, 0.005}, 3);
  const std::vector<Vec3> points = sampled_cloud(plate, {.points = 1000}, 4);
  EXPECT_TRUE(
      contains(refusal<GeometryError>([&] { fit_cloud_surface(points); }), "scan it more densely"));
}

TEST(Outliers, OfACompleteCloudNoPointIsGivenUp) {
  const std::vector<Vec3> even = sampled_cloud(geodesic_sphere(20), {.points = 8000}, 7);
  EXPECT_EQ(reconstruct_detail::find_non_isolated_points(even).size(), even.size());
  // Where the density falls to a twentieth in one step, a few at the step look like outliers.
  const std::vector<Vec3> step =
      sampled_cloud(geodesic_sphere(20), {.points = 8000, .fall = 0.05, .step = true}, 7);
  EXPECT_GE(reconstruct_detail::find_non_isolated_points(step).size(), step.size() - 20);
}

TEST(Outliers, PointsThatAreRepeatedCountOnce) {
  const std::vector<Vec3> once = sampled_cloud(geodesic_sphere(20), {.points = 2000}, 7);
  std::vector<Vec3> many;
  for (const Vec3& p : once) many.insert(many.end(), 8, p);
  const std::vector<std::uint32_t> first = reconstruct_detail::find_first_duplicates(many);
  for (std::uint32_t i = 0; i < many.size(); ++i) EXPECT_EQ(first[i], 8 * (i / 8));
  const std::vector<std::uint32_t> own = reconstruct_detail::find_first_duplicates(once);
  for (std::uint32_t i = 0; i < once.size(); ++i) EXPECT_EQ(own[i], i);
}

TEST(Outliers, NearlyAllThatLieOffTheSurfaceAreFound) {
  const std::vector<Vec3> points =
      sampled_cloud(geodesic_sphere(20), {.points = 8000, .outliers = 0.02}, 8);
  std::size_t rock = 0, off = 0;
  for (const std::uint32_t i : reconstruct_detail::find_non_isolated_points(points)) {
    rock += i < 8000;
    off += i >= 8000 && std::abs(points[i].norm() - 1.0) > 0.1;  // 2.5 spacings of 0.04
  }
  EXPECT_GE(rock, 7960u);
  EXPECT_LE(off, 2u);
}

TEST(CloudSurface, OutliersThatAreLeftDoNotDecide) {
  const std::vector<Vec3> points =
      sampled_cloud(geodesic_sphere(20), {.points = 8000, .outliers = 0.02}, 8);
  std::vector<Vec3> kept;
  for (const std::uint32_t i : reconstruct_detail::find_non_isolated_points(points)) {
    kept.push_back(points[i]);
  }
  ASSERT_GT(kept.size(), 8000u);
  const CloudSurface surface = fit_cloud_surface(kept);
  EXPECT_TRUE(inspect_mesh(surface.mesh).is_closed());
  EXPECT_NEAR(solid_mass_properties(surface.mesh, 1.0).volume, 4.0 / 3.0 * kPi, 0.01 * 4.2);
}

/// `count` points strewn over a box with its middle at the origin.
std::vector<Vec3> points_on_box(const Vec3& sides, int count, std::uint64_t seed) {
  Random random(seed);
  const Vec3 areas(sides.y() * sides.z(), sides.z() * sides.x(), sides.x() * sides.y());
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double at = random.uniform(0.0, areas.sum());
    const int axis = at < areas[0] ? 0 : at < areas[0] + areas[1] ? 1 : 2;
    Vec3 share(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    share[axis] = random.uniform() < 0.5 ? -0.5 : 0.5;
    points.push_back(share.cwiseProduct(sides));
  }
  return points;
}

/// The share of normals that face into the box; those between two sides don't count.
double inward_share(const std::vector<Vec3>& normals, const std::vector<Vec3>& points,
                    const Vec3& sides) {
  double inward = 0.0, counted = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Index axis = 0;
    const Vec3 share = points[i].cwiseQuotient(sides);
    if (share.cwiseAbs().maxCoeff(&axis) > 0.5 + 1e-9) continue;  // off the box
    const double along = normals[i][axis] * share[axis];
    if (std::abs(along) < 0.4) continue;
    counted += 1.0;
    inward += along < 0.0;
  }
  return inward / counted;
}

// The point farthest from the middle is where the first normal is chosen. Of an outlier it may be
// either, and all the others followed it.
TEST(CloudNormals, OneOutlierFarFromTheMiddleTurnsNoneInward) {
  const Vec3 sides(1.0, 0.3, 0.15);
  std::vector<Vec3> points = points_on_box(sides, 2000, 1);
  points.emplace_back(0.56, 0.0, 0.09);  // nearly level with a face
  for (const double lean : {-0.2, 0.2}) {
    std::vector<Vec3> normals = reconstruct_detail::estimate_normals(points, 10);
    normals.back() = Vec3(lean, 0.0, -1.0).normalized();
    reconstruct_detail::orient_outward(normals, points);
    EXPECT_LT(inward_share(normals, points, sides), 0.02);
  }
}

// From one face of a plate to the other the way leads over two sharp edges.
TEST(CloudNormals, BothFacesOfAPlateFaceOutward) {
  for (const double thickness : {0.07, 0.1, 0.15}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Vec3 sides(1.0, 0.9, thickness);
      const std::vector<Vec3> points = points_on_box(sides, 2000, seed);
      std::vector<Vec3> normals = reconstruct_detail::estimate_normals(points, 18);
      reconstruct_detail::orient_outward(normals, points,
                                         reconstruct_detail::NormalPropagation::kCircularArc);
      EXPECT_LT(inward_share(normals, points, sides), 0.05)
          << "thickness " << thickness << ", seed " << seed;
    }
  }
}

// A third of a spacing above a face: no farther from the next point than others are.
TEST(CloudSurface, PointsJustOffAFlatFaceAreOutliers) {
  const Vec3 sides(1.0, 0.8, 0.6);
  std::vector<Vec3> points = points_on_box(sides, 4000, 2);
  const double spacing = std::sqrt(3.76 / 4000.0);
  points.emplace_back(0.1, 0.1, 0.3 + 0.3 * spacing);
  points.emplace_back(-0.2, 0.15, 0.3 + 0.3 * spacing);
  points.emplace_back(0.05, -0.4 - 0.3 * spacing, 0.02);
  const CloudSurface surface = fit_cloud_surface(points);
  EXPECT_GE(surface.outliers, 3u);
  EXPECT_LE(surface.outliers, 5u) << "points of the box left out";
  const Bounds box = bounds(surface.mesh);
  EXPECT_LT(box.high.z(), 0.3 + 1e-9);
  EXPECT_GT(box.low.y(), -0.4 - 1e-9);
}

// Each makes the other's neighbours look rough.
TEST(CloudSurface, TwoOutliersBesideOneAnotherHideNeither) {
  const Vec3 sides(1.0, 0.8, 0.6);
  std::vector<Vec3> points = points_on_box(sides, 4000, 2);
  const double spacing = std::sqrt(3.76 / 4000.0);
  points.emplace_back(0.1, 0.1, 0.3 + 1.2 * spacing);
  points.emplace_back(0.1 + 0.5 * spacing, 0.1, 0.3 + spacing);
  const CloudSurface surface = fit_cloud_surface(points);
  EXPECT_GE(surface.outliers, 2u);
  EXPECT_LE(surface.outliers, 4u) << "points of the box left out";
  EXPECT_LT(bounds(surface.mesh).high.z(), 0.3 + 1e-9);
}

TEST(CloudSurface, PointsThatBoundNoBodyAreRefusedAsSuch) {
  Random random(4);
  std::vector<Vec3> plane, line;
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(), y = random.uniform();
    plane.emplace_back(x, y, 0.5 * x);
    line.emplace_back(x, 0.5 * x, 0.2 * x);
  }
  const auto message = [](const std::vector<Vec3>& points) {
    return refusal<GeometryError>([&] { fit_cloud_surface(points); });
  };
  EXPECT_TRUE(
      contains(message(plane), "all 2000 points lie in a plane and do not enclose a block; scan"));
  EXPECT_TRUE(contains(message(line), "all 2000 points lie on a line"));
  EXPECT_TRUE(contains(message(std::vector<Vec3>(2000, Vec3(1, 2, 3))), "lie at one point"));
}

TEST(CloudSurface, TooFewPointsAndOptionsOutOfRangeAreRefused) {
  EXPECT_TRUE(contains(refusal([] { fit_cloud_surface(std::vector<Vec3>(10, Vec3::Zero())); }),
                       "10 points are too few for a block; at least 500 are needed"));
  const std::vector<Vec3> none;
  EXPECT_TRUE(contains(refusal([&] { fit_cloud_surface(none, {.averaging_cell = 0.0}); }),
                       "cell = 0; must be above 0 and at most 0.1"));
  EXPECT_TRUE(
      contains(refusal([&] { fit_cloud_surface(none, {.hole_ball_radius = 0.0}); }), "trim"));
}

}  // namespace
}  // namespace clast
