// The mass between the terrains before and after it came down.
#include "terrain/released_mass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

constexpr double kRadius = 10.0, kHeight = 4.0;
constexpr double kDomeVolume = 0.5 * std::numbers::pi * kRadius * kRadius * kHeight;

/// A paraboloid on a slope, cut off by it at a circle around (x, y).
double dome(double x, double y, double at_x, double at_y, double size = 1.0) {
  const double u = (std::pow(x - at_x, 2) + std::pow(y - at_y, 2)) / std::pow(size * kRadius, 2);
  return std::max(0.0, size * kHeight * (1.0 - u));
}

class Released : public testing::Test {
 protected:
  Terrain ground(const TriangleMesh& mesh, const Vec3& offset = Vec3::Zero()) {
    TriangleMesh moved = mesh;
    for (Vec3& vertex : moved.vertices) vertex += offset;
    const auto file = folder_ / ("ground" + std::to_string(++count_) + ".obj");
    write_mesh(file, moved);
    return read_terrain({.surface = {file}, .spike_steepness = 0.0});
  }
  /// Triangles of another size than those of the ground before, so that nearly all edges cross.
  Terrain slope_after(const Vec3& offset = Vec3::Zero()) {
    return ground(squares(57, 0.57, [&](double x, double y) { return slope_.at(x, y); }), offset);
  }
  Terrain dome_before(const Vec3& offset = Vec3::Zero()) {
    return ground(
        squares(80, 0.4, [&](double x, double y) { return slope_.at(x, y) + dome(x, y, 16, 15); }),
        offset);
  }

  const SlopedGround slope_;
  const ScratchFolder folder_;
  int count_ = 0;
};

void expect_solid(const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(mesh);
  EXPECT_TRUE(report.is_closed()) << report.summary();
  EXPECT_TRUE(report.is_oriented());
  EXPECT_EQ(report.components, 1u);
  EXPECT_TRUE(find_self_intersections(mesh).empty());
  EXPECT_GT(signed_volume(mesh), 0.0);
}

// What lies below the least thickness t of a paraboloid of height h is the share (t/h)^2 of its
// volume.
TEST_F(Released, AParaboloidHasItsVolume) {
  const Terrain before = dome_before(), after = slope_after();
  for (const double least : {0.0, 0.1, 1.0}) {
    const ReleasedMass mass = find_released_mass(before, after, {.min_thickness = least});
    ASSERT_EQ(mass.bodies.size(), 1u);
    const double share = 1.0 - std::pow(least / kHeight, 2);
    EXPECT_NEAR(mass.volume() / (share * kDomeVolume), 1.0, 5e-3) << least;
    // The outline is within a cell of the circle.
    const double area = std::numbers::pi * kRadius * kRadius * (1.0 - least / kHeight);
    EXPECT_NEAR(mass.bodies[0].plan_area, area, 0.4 * 2.0 * std::numbers::pi * kRadius);
    EXPECT_NEAR(mass.bodies[0].max_thickness, kHeight, 0.01);
    expect_solid(mass.bodies[0].mesh);
    EXPECT_TRUE(mass.excluded.empty());
    EXPECT_TRUE(mass.notes.empty());
    EXPECT_NEAR(mass.median_edge_before, 0.4, 0.15);
    EXPECT_NEAR(mass.median_edge_after, 0.57, 0.2);
  }
}

// A niche with an upright back and level floor: exact, whichever of the two has finer triangles.
TEST_F(Released, ANicheWithAnUprightBackIsExact) {
  TriangleMesh after;
  after.vertices = {{0, 0, 9},  {4, 0, 9},  {4, 20, 9},  {0, 20, 9},  // above
                    {4, 0, 5},  {12, 0, 9}, {12, 20, 9}, {4, 20, 5},  // ramp
                    {30, 0, 9}, {30, 20, 9}};
  after.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7},
                     {1, 4, 7}, {1, 7, 2}, {5, 8, 9}, {5, 9, 6}};
  for (const int n : {1, 40}) {
    const Terrain before = ground(squares(n, 40.0 / n, [](double, double) { return 9.0; }));
    const ReleasedMass mass = find_released_mass(before, ground(after), {.min_thickness = 0.0});
    ASSERT_EQ(mass.bodies.size(), 1u);
    EXPECT_NEAR(mass.volume(), 0.5 * 8.0 * 4.0 * 20.0, 0.01);
    expect_solid(mass.bodies[0].mesh);
    ASSERT_EQ(mass.notes.size(), 1u);
    EXPECT_TRUE(contains(mass.notes[0], "body 1 ends at a vertical wall of up to 4 m"));
  }
}

// Against sums over a fine grid, on surfaces without any order; and every corner is on a surface.
TEST_F(Released, IsTheIntegralOfTheThicknessOnRoughGround) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Random random(seed);
    const auto rough = [&](int n, double size) {
      TriangleMesh mesh = squares(n, size / n, [&](double x, double y) {
        return 0.6 * x + random.uniform() + 2.0 * std::sin(0.5 * x) * std::sin(0.4 * y);
      });
      for (Vec3& v : mesh.vertices) {
        v.x() += 0.3 * size / n * (random.uniform() - 0.5);
        v.y() += 0.3 * size / n * (random.uniform() - 0.5);
      }
      return mesh;
    };
    const Terrain before = ground(rough(23, 20.0)), after = ground(rough(31, 21.0));
    const double least = 0.3;
    const ReleasedMass mass = find_released_mass(
        before, after, {.min_thickness = least, .bodies = "all", .min_volume = 0.0});
    EXPECT_GT(mass.bodies.size(), 5u);
    const TerrainSurface upper = make_terrain_surface(before), lower = make_terrain_surface(after);
    double sum = 0.0;
    const double step = 0.02;
    for (double x = step / 2; x < 22.0; x += step) {
      for (double y = step / 2; y < 22.0; y += step) {
        const auto top = upper.height_at(x, y, 0.0), base = lower.height_at(x, y, 0.0);
        if (top && base && *top - *base > least) sum += (*top - *base) * step * step;
      }
    }
    EXPECT_NEAR(mass.volume() / sum, 1.0, 2e-3);
    for (const ReleasedBody& body : mass.bodies) {
      expect_solid(body.mesh);
      for (const Vec3& corner : body.mesh.vertices) {
        const auto top = upper.height_at(corner.x(), corner.y(), 0.0);
        const auto base = lower.height_at(corner.x(), corner.y(), 0.0);
        if (!top || !base) continue;  // on the border
        EXPECT_LT(std::min(std::abs(*top - corner.z()), std::abs(*base - corner.z())), 1e-5);
      }
    }
  }
}

// Two rasters of one grid, far from the origin of the map, each with a local origin of its own.
TEST_F(Released, LiesOnTheMap) {
  const double west = 652000.0, south = 5203000.0;
  const auto write = [&](const char* name, int columns, bool with_dome) {
    write_asc(folder_ / name, columns, 60, west, south, 0.5, [&](double x, double y) {
      return 1800.0 + 0.2 * (x - west) + (with_dome ? dome(x, y, west + 14, south + 15) : 0.0);
    });
    return read_terrain({.surface = {folder_ / name}});
  };
  const Terrain before = write("before.asc", 60, true), after = write("after.asc", 90, false);
  ASSERT_NE(before.frame.origin, after.frame.origin);
  const ReleasedMass mass = find_released_mass(before, after);
  EXPECT_NEAR(mass.volume() / kDomeVolume, 1.0, 5e-3);
  expect_solid(mass.bodies[0].mesh);
  const Bounds box = bounds(mass.bodies[0].mesh);
  EXPECT_NEAR(box.low.x(), west + 4.0, 0.5);
  EXPECT_NEAR(box.high.y(), south + 25.0, 0.5);
  EXPECT_GT(box.low.z(), 1800.0);
  EXPECT_NEAR(mass.bodies[0].centre.x(), west + 14.0, 0.5);
}

TEST_F(Released, OfSeveralBodiesThoseAskedForAreTaken) {
  const Terrain before = ground(squares(100, 0.4, [&](double x, double y) {
    return slope_.at(x, y) + dome(x, y, 12, 12) + dome(x, y, 30, 30, 0.5) + dome(x, y, 30, 8, 0.25);
  }));
  const Terrain after =
      ground(squares(40, 1.0, [&](double x, double y) { return slope_.at(x, y); }));
  const ReleasedMass largest = find_released_mass(before, after, {.min_thickness = 0.0});
  ASSERT_EQ(largest.bodies.size(), 1u);
  ASSERT_EQ(largest.excluded.size(), 2u);
  EXPECT_NEAR(largest.volume() / kDomeVolume, 1.0, 5e-3);
  EXPECT_NEAR(largest.excluded[0].volume / kDomeVolume, 0.125, 2e-3);
  EXPECT_NEAR(largest.excluded_volume() / kDomeVolume, 0.125 + 1.0 / 64.0, 3e-3);
  const ReleasedMass two = find_released_mass(before, after, {.bodies = "1,3"});
  ASSERT_EQ(two.bodies.size(), 2u);
  EXPECT_EQ(two.bodies[1].rank, 3u);
  EXPECT_EQ(two.excluded[0].rank, 2u);
  EXPECT_EQ(find_released_mass(before, after, {.bodies = "all"}).bodies.size(), 3u);
  EXPECT_EQ(find_released_mass(before, after, {.bodies = "all", .min_volume = 20.0}).bodies.size(),
            2u);
  const std::string said =
      refusal<InputError>([&] { find_released_mass(before, after, {.bodies = "4"}); });
  EXPECT_TRUE(contains(said, "`bodies` = 4: there are 3 bodies")) << said;
}

TEST_F(Released, APolygonCutsItOff) {
  write_text_file(folder_ / "half.geojson",
                  R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
"geometry":{"type":"Polygon","coordinates":[[[16,-5],[50,-5],[50,50],[16,50],[16,-5]]]}}]})");
  const ReleasedMass mass = find_released_mass(
      dome_before(), slope_after(), {.min_thickness = 0.0, .polygon = folder_ / "half.geojson"});
  EXPECT_NEAR(mass.volume() / kDomeVolume, 0.5, 3e-3);
  expect_solid(mass.bodies[0].mesh);
  EXPECT_NEAR(bounds(mass.bodies[0].mesh).low.x(), 16.0, 1e-5);
  EXPECT_TRUE(contains(mass.notes.at(0), "a vertical wall of up to 4 m"));
}

// A roof over the niche: two heights say nothing of it; the highest points of a grid do.
TEST_F(Released, WhatOverhangsIsRefusedAndTakenAsAGrid) {
  TriangleMesh overhang;
  overhang.vertices = {{0, 0, 5}, {8, 0, 5},  {8, 30, 5}, {0, 30, 5},
                       {6, 0, 9}, {6, 30, 9}, {30, 0, 9}, {30, 30, 9}};
  overhang.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {4, 6, 7}, {4, 7, 5}};
  const Terrain before = ground(squares(30, 1.0, [](double, double) { return 9.0; }));
  const Terrain after = ground(overhang);
  const std::string said =
      refusal<GeometryError>([&] { find_released_mass(before, after, {.min_thickness = 0.5}); });
  EXPECT_TRUE(contains(said, "overhang")) << said;
  const ReleasedMass mass =
      find_released_mass(before, after, {.min_thickness = 0.0, .resolution = 0.1});
  EXPECT_NEAR(mass.volume() / (6.0 * 4.0 * 30.0), 1.0, 0.02);
  expect_solid(mass.bodies[0].mesh);
}

TEST_F(Released, IsTheSameFromAGrid) {
  const ReleasedMass mass = find_released_mass(dome_before(), slope_after(), {.resolution = 0.2});
  EXPECT_NEAR(mass.volume() / kDomeVolume, 1.0, 5e-3);
  expect_solid(mass.bodies[0].mesh);
}

TEST_F(Released, RefusesWithTheNextStep) {
  const Terrain before = dome_before(), after = slope_after();
  const auto refused = [](const Terrain& one, const Terrain& two,
                          const ReleasedMassOptions& options, const std::string& part) {
    const std::string said = refusal<Error>([&] { find_released_mass(one, two, options); });
    EXPECT_TRUE(contains(said, part)) << said;
  };
  refused(after, before, {}, "check that the two are not swapped");
  refused(before, after, {.min_thickness = 5.0}, "give a smaller `min_thickness`");
  refused(before, before, {}, "`before` is nowhere more than 0.1 m above `after`");
  refused(before, slope_after({1000, 0, 0}), {}, "do not overlap: one has x 0.0 to 32.0");
  refused(before, after, {.min_thickness = std::nan("")}, "`min_thickness` = nan: must be");
  refused(before, after, {.min_thickness = -1.0}, "`min_thickness` = -1: must be");
  refused(before, after, {.resolution = 0.0}, "`resolution` = 0: must be");
  refused(before, after, {.bodies = "some"}, "must be largest, all, or numbers");
  refused(before, after, {.bodies = "0"}, "must be largest, all, or numbers");
  refused(before, after, {.polygon = folder_ / "none.geojson"}, "none.geojson");
  Terrain other = after, first = before;
  other.frame.crs = "EPSG:2154";
  first.frame.crs = "EPSG:25832";
  refused(first, other, {},
          "in the map system ETRS89 / UTM zone 32N (EPSG:25832), `after` in RGF93 v1 / Lambert-93 "
          "(EPSG:2154)");
  EXPECT_TRUE(contains(find_released_mass(before, other).notes.at(0), "has no map system"));
}

}  // namespace
}  // namespace clast
