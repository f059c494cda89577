// The quarry of the paper, as TIN and as raster, place by place.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>

#include "core/random.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/terrain/asc_grid.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

const std::vector<std::string> kNames = {"Blue", "Gray", "Red"};

Terrain tin() {
  TerrainOptions options{.zones = {"blue", "gray", "red"}, .up = "y"};
  for (const std::string& name : kNames) {
    options.surface.push_back(test_data("authume/terrain/DTM_" + name + "_zone.stl"));
  }
  return read_terrain(options);
}

/// The facets as the files state them, in the order of the files, z up: read without any library.
std::vector<std::array<Vec3, 3>> facets() {
  std::vector<std::array<Vec3, 3>> result;
  for (const std::string& name : kNames) {
    std::ifstream file(test_data("authume/terrain/DTM_" + name + "_zone.stl"));
    std::size_t corner = 0;
    for (std::string word; file >> word;) {
      if (word != "vertex") continue;
      double x = 0.0, y = 0.0, z = 0.0;
      file >> x >> y >> z;
      if (corner == 0) result.emplace_back();
      result.back()[corner] = {x, -z, y};
      corner = (corner + 1) % 3;
    }
  }
  return result;
}

/// Height of a triangle over (x, y), -infinity beside it.
double height_over(const std::array<Vec3, 3>& t, double x, double y) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0];
  const double area = ab.x() * ac.y() - ab.y() * ac.x();
  if (area == 0.0) return kNone;
  const double dx = x - t[0].x(), dy = y - t[0].y();
  const double v = (dx * ac.y() - dy * ac.x()) / area, w = (ab.x() * dy - ab.y() * dx) / area;
  if (v < -1e-9 || w < -1e-9 || v + w > 1.0 + 1e-9) return kNone;
  return t[0].z() + v * ab.z() + w * ac.z();
}

std::vector<std::array<Vec3, 3>> triangles_of(const Terrain& terrain) {
  std::vector<std::array<Vec3, 3>> result;
  for (const auto& [a, b, c] : terrain.surface.triangles) {
    const std::vector<Vec3>& v = terrain.surface.vertices;
    result.push_back(
        {terrain.frame.to_map(v[a]), terrain.frame.to_map(v[b]), terrain.frame.to_map(v[c])});
  }
  return result;
}

/// The highest triangle over every place of a list.
std::vector<double> highest(const std::vector<std::array<Vec3, 3>>& triangles,
                            const std::vector<Vec2>& places) {
  std::vector<double> result(places.size(), kNone);
  for (const std::array<Vec3, 3>& t : triangles) {
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec2& p = places[i];
      if (p.x() < low.x() - 1e-6 || p.x() > high.x() + 1e-6 || p.y() < low.y() - 1e-6 ||
          p.y() > high.y() + 1e-6) {
        continue;
      }
      result[i] = std::max(result[i], height_over(t, p.x(), p.y()));
    }
  }
  return result;
}

TEST(AuthumeGround, HasNoHoleAndItsTrianglesAreThoseOfTheFiles) {
  const Terrain terrain = tin();
  EXPECT_EQ(terrain.report.components, 1u);
  EXPECT_EQ(terrain.report.open_holes, 0u);
  EXPECT_EQ(terrain.report.filled_holes, 0u);
  EXPECT_EQ(terrain.report.levelled_spikes, 0u);
  EXPECT_EQ(terrain.report.closed_cracks, 0u);
  EXPECT_EQ(facets().size(), 9001u);
  EXPECT_EQ(terrain.surface.triangles.size(), 9001u);
}

TEST(AuthumeGround, HeightsAreThoseOfTheFilesAtTenThousandPlaces) {
  const Terrain terrain = tin();
  const Bounds box = bounds(terrain.surface);
  Random random(10000);
  std::vector<Vec2> places;
  for (int i = 0; i < 10000; ++i) {
    places.emplace_back(random.uniform(box.low.x(), box.high.x()),
                        random.uniform(box.low.y(), box.high.y()));
  }
  const std::vector<double> wanted = highest(facets(), places);
  const std::vector<double> found = highest(triangles_of(terrain), places);
  std::size_t covered = 0;
  double worst = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(std::isfinite(wanted[i]), std::isfinite(found[i])) << places[i].transpose();
    if (!std::isfinite(wanted[i])) continue;
    ++covered;
    worst = std::max(worst, std::abs(wanted[i] - found[i]));
  }
  EXPECT_GT(covered, 8000u);
  EXPECT_LE(worst, 1e-6);
  RecordProperty("worst_m", std::to_string(worst));
}

TEST(AuthumeGround, HeightsAreThoseOfTheRasterAtAllCellCentres) {
  const AscGrid dem(test_data("authume/gis/dem_0p5m.asc"));
  std::vector<Vec2> places;
  std::vector<double> wanted;
  for (int j = 0; j < dem.rows; ++j) {
    for (int i = 0; i < dem.columns; ++i) {
      if (!dem.at(i, j)) continue;
      places.emplace_back(dem.west + dem.cell * (i + 0.5), dem.south + dem.cell * (j + 0.5));
      wanted.push_back(*dem.at(i, j));
    }
  }
  const std::vector<double> found = highest(triangles_of(tin()), places);
  double worst = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_TRUE(std::isfinite(found[i])) << places[i].transpose();
    worst = std::max(worst, std::abs(found[i] - wanted[i]));
  }
  EXPECT_EQ(places.size(), 100064u - 14431u);
  EXPECT_LT(worst, 1e-3);
}

// From the raster: a vertex at every cell centre with the raster's own value, and on every
// triangle whose three cells are of one class the zone of that class.
TEST(AuthumeGround, TheSameFromItsRasters) {
  const AscGrid dem(test_data("authume/gis/dem_0p5m.asc"));
  const AscGrid classes(test_data("authume/gis/zones_0p5m.asc"));
  const Terrain terrain = read_terrain(
      {.surface = {test_data("authume/gis/dem_0p5m.asc")},
       .zones = {test_data("authume/gis/zones_0p5m.asc").string() + ":1=blue,2=gray,3=red"}});
  EXPECT_EQ(terrain.report.levelled_spikes, 0u);
  const auto cell = [&](const Vec3& at) {
    return std::pair(static_cast<int>(std::floor((at.x() - dem.west) / dem.cell)),
                     static_cast<int>(std::floor((at.y() - dem.south) / dem.cell)));
  };
  for (const Vec3& local : terrain.surface.vertices) {
    const Vec3 v = terrain.frame.to_map(local);
    const auto [i, j] = cell(v);
    ASSERT_TRUE(dem.at(i, j)) << v.transpose();
    EXPECT_NEAR(v.x(), dem.west + dem.cell * (i + 0.5), 1e-9);
    EXPECT_NEAR(v.y(), dem.south + dem.cell * (j + 0.5), 1e-9);
    EXPECT_NEAR(v.z(), *dem.at(i, j), 1e-9);
  }
  const std::map<double, std::string> names = {{1, "blue"}, {2, "gray"}, {3, "red"}};
  std::size_t compared = 0;
  const std::vector<std::array<Vec3, 3>> triangles = triangles_of(terrain);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::vector<double> corner;
    for (const Vec3& v : triangles[t]) {
      corner.push_back(classes.at(cell(v).first, cell(v).second).value_or(-1.0));
    }
    if (corner[0] != corner[1] || corner[0] != corner[2]) continue;
    EXPECT_EQ(terrain.zone_names[terrain.zone[t]], names.at(corner[0]));
    ++compared;
  }
  EXPECT_GT(compared, triangles.size() * 9 / 10);
}

}  // namespace
}  // namespace clast
