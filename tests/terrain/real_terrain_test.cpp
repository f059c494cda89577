// Surveyed grounds against what is known of them.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "mesh/point_cloud.hpp"
#include "terrain/terrain_file.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/working_folder.hpp"
#include "tests/terrain/asc_grid.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

TerrainOptions authume() {
  return {.surface = {test_data("authume/terrain/DTM_Blue_zone.stl"),
                      test_data("authume/terrain/DTM_Gray_zone.stl"),
                      test_data("authume/terrain/DTM_Red_zone.stl")},
          .zones = {"blue", "gray", "red"},
          .up = "y"};
}

/// Height of the highest triangle over (x, y), all of them tried.
std::optional<double> highest_over(const Terrain& terrain, const Vec2& at) {
  std::optional<double> highest;
  for (const auto& [ia, ib, ic] : terrain.surface.triangles) {
    const Vec3 a = terrain.surface.vertices[ia];
    const Vec3 ab = terrain.surface.vertices[ib] - a, ac = terrain.surface.vertices[ic] - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0.0) continue;
    const double x = at.x() - a.x(), y = at.y() - a.y();
    const double v = (x * ac.y() - y * ac.x()) / area, w = (ab.x() * y - ab.y() * x) / area;
    if (v < 0.0 || w < 0.0 || v + w > 1.0) continue;
    const double z = a.z() + v * ab.z() + w * ac.z();
    if (!highest || z > *highest) highest = z;
  }
  return highest;
}

/// Facets whose normal, as the file states it, points against y.
std::size_t facets_against_y(const std::filesystem::path& path, bool against) {
  std::ifstream file(path);
  std::size_t count = 0;
  for (std::string word; file >> word;) {
    double x = 0.0, y = 0.0;
    if (word == "normal" && file >> x >> y && (y < 0.0) == against) ++count;
  }
  return count;
}

// 9,001 facets and 4,640 vertices are what the dataset's description says. The files' normals point
// down; the few that point up there are overhangs, which stay overhangs.
TEST(RealTerrain, AuthumeHasItsZonesAndFacesUp) {
  const TerrainOptions options = authume();
  const Terrain terrain = read_terrain(options);
  EXPECT_EQ(terrain.report.triangles_read, 9001u);
  EXPECT_EQ(terrain.surface.triangles.size(), 9001u);
  EXPECT_EQ(terrain.surface.vertices.size(), 4640u);
  EXPECT_EQ(terrain.report.components, 1u);
  EXPECT_EQ(terrain.zone_names, (std::vector<std::string>{"blue", "gray", "red"}));
  std::vector<std::size_t> count(3, 0);
  for (const std::uint16_t zone : terrain.zone) ++count.at(zone);
  EXPECT_EQ(count, (std::vector<std::size_t>{5300, 2953, 748}));
  EXPECT_EQ(terrain.report.flipped_triangles, 9001u);
  std::size_t down = 0, up = 0;
  for (const std::filesystem::path& file : options.surface) {
    down += facets_against_y(file, true);
    up += facets_against_y(file, false);
  }
  EXPECT_EQ(down + up, 9001u);
  EXPECT_LT(up, down / 50);
  EXPECT_EQ(facing_down(terrain), up);
  EXPECT_TRUE(terrain.frame.origin.isZero(0.0));
}

TEST(RealTerrain, AuthumeHasTheHeightsOfItsRaster) {
  const Terrain terrain = read_terrain(authume());
  const AscGrid dem(test_data("authume/gis/dem_0p5m.asc"));
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < dem.values.size(); ++i) {
    if (dem.values[i] != dem.nodata) known.push_back(i);
  }
  ASSERT_GT(known.size(), 10000u);
  constexpr std::size_t kSamples = 2000;
  double worst = 0.0;
  std::size_t missing = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t cell = known[k * known.size() / kSamples];
    const std::optional<double> height = highest_over(terrain, dem.centre(cell));
    if (!height) {
      ++missing;
      continue;
    }
    worst = std::max(worst, std::abs(*height - dem.values[cell]));
  }
  EXPECT_EQ(missing, 0u);
  EXPECT_LT(worst, 1e-3);
}

TEST(RealTerrain, AuthumeRasterExportAgreesWithTheOneSampledElsewhere) {
  const ScratchFolder folder;
  export_terrain(folder / "dem.tif", read_terrain(authume()), "z", 0.5);
  const Terrain ours = read_terrain({.surface = {folder / "dem.tif"}});
  const AscGrid dem(test_data("authume/gis/dem_0p5m.asc"));
  std::map<std::pair<long, long>, double> heights;
  const auto key = [](const Vec2& p) {
    return std::pair{std::lround(4 * p.x()), std::lround(4 * p.y())};
  };
  for (const Vec3& v : ours.surface.vertices) heights[key(v.head<2>())] = v.z();
  std::size_t compared = 0;
  for (std::size_t i = 0; i < dem.values.size(); ++i) {
    const auto found = heights.find(key(dem.centre(i)));
    if (dem.values[i] == dem.nodata || found == heights.end()) continue;
    EXPECT_NEAR(found->second, dem.values[i], 1e-3);
    ++compared;
  }
  EXPECT_GT(compared, 10000u);
}

TEST(RealTerrain, AuthumeByRasterHasTheSameZones) {
  const Terrain terrain = read_terrain(
      {.surface = {test_data("authume/gis/dem_0p5m.asc")},
       .zones = {test_data("authume/gis/zones_0p5m.asc").string() + ":1=blue,2=gray,3=red"}});
  EXPECT_EQ(terrain.zone_names, (std::vector<std::string>{"blue", "gray", "red"}));
  EXPECT_EQ(facing_down(terrain), 0u);
  // Plan areas of the zones against those of the TIN.
  const auto areas = [](const Terrain& ground) {
    std::vector<double> area(3, 0.0);
    for (std::size_t t = 0; t < ground.zone.size(); ++t) {
      area[ground.zone[t]] += normal_of(ground, t).z() / 2.0;
    }
    return area;
  };
  const std::vector<double> raster = areas(terrain), tin = areas(read_terrain(authume()));
  for (std::size_t zone = 0; zone < 3; ++zone) {
    EXPECT_NEAR(raster[zone] / tin[zone], 1.0, 0.05) << terrain.zone_names[zone];
  }
}

// One vertex per cell with a height, at its centre, with the value of the ascii grid.
TEST(RealTerrain, TirolRasterHasTheHeightsOfItsAsciiForm) {
  const Terrain tif = read_terrain({.surface = {test_data("terrain/tirol_gar_5m.tif")}});
  const AscGrid grid(test_data("terrain/tirol_gar_5m.asc"));
  EXPECT_EQ(tif.surface.vertices.size(), 140u * 140u);
  EXPECT_EQ(tif.surface.triangles.size(), 2u * 139 * 139);
  EXPECT_EQ(facing_down(tif), 0u);
  EXPECT_EQ(tif.frame.crs, "EPSG:31287");
  std::map<std::pair<long, long>, double> heights;
  const auto key = [](const Vec2& p) { return std::pair{std::lround(p.x()), std::lround(p.y())}; };
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    heights[key(grid.centre(i))] = grid.values[i];
  for (const Vec3& local : tif.surface.vertices) {
    const Vec3 v = tif.frame.to_map(local);
    ASSERT_TRUE(heights.contains(key(v.head<2>()))) << v.transpose();
    EXPECT_NEAR(heights[key(v.head<2>())], v.z(), 1e-2);
  }
  const Terrain asc = read_terrain({.surface = {test_data("terrain/tirol_gar_5m.asc")}});
  EXPECT_EQ(asc.surface.triangles.size(), tif.surface.triangles.size());
}

TEST(RealTerrain, ReliefOfTheRastersIsAsDocumented) {
  const auto relief = [](const std::string& name) {
    const Terrain terrain = read_terrain({.surface = {test_data("terrain/" + name)}});
    const Bounds box = bounds(terrain.surface);
    return std::tuple{terrain.frame.crs, box.low.z(), box.high.z()};
  };
  const auto [gabilan_crs, gabilan_low, gabilan_high] = relief("gabilan_a_1m.tif");
  EXPECT_EQ(gabilan_crs, "EPSG:32611");
  EXPECT_NEAR(gabilan_low, 199.0, 1.0);
  EXPECT_NEAR(gabilan_high, 292.0, 1.0);
  const auto [wog_crs, wog_low, wog_high] = relief("tirol_wog_5m.tif");
  EXPECT_EQ(wog_crs, "EPSG:31287");
  EXPECT_NEAR(wog_low, 1255.0, 1.0);
  EXPECT_NEAR(wog_high, 1416.0, 1.0);
}

TEST(RealTerrain, TschamutProxyIsRead) {
  const Terrain terrain = read_terrain({.surface = {test_data("tschamut2014/terrain.asc")}});
  EXPECT_LE(terrain.surface.vertices.size(), 43u * 46u);
  EXPECT_GT(terrain.surface.vertices.size(), 1000u);
  EXPECT_EQ(facing_down(terrain), 0u);
}

#ifdef CLAST_HAS_LAZ_PERF

class CompressedLidar : public WorkingFolder {
 protected:
  CompressedLidar() { std::filesystem::create_symlink(CLAST_NPM, "node_modules"); }
  std::filesystem::path file = test_data("terrain/lidr_topography.laz");
};

TEST_F(CompressedLidar, FillsTheBoxOfItsHeader) {
  std::ifstream stream(file, std::ios::binary);
  std::array<double, 6> box{};  // highest and lowest x, y, z
  stream.seekg(179);
  stream.read(reinterpret_cast<char*>(box.data()), sizeof box);
  Bounds read;
  const CloudSummary summary = stream_cloud(file, [&](const PointBatch& batch) {
    for (const Vec3& point : batch.points) read.include(point);
  });
  EXPECT_EQ(summary.point_count + summary.withheld_points, 73403u);
  EXPECT_EQ(summary.withheld_points, 0u);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    EXPECT_NEAR(read.high[k], box[2 * axis], 1e-6);
    EXPECT_NEAR(read.low[k], box[2 * axis + 1], 1e-6);
  }
}

TEST_F(CompressedLidar, BecomesATerrain) {
  const Terrain terrain = read_terrain({.surface = {file}});
  EXPECT_EQ(terrain.frame.crs, "EPSG:2949");
  // 300 m by 300 m with about four points of ground per cell of 10 m.
  EXPECT_GT(terrain.surface.vertices.size(), 700u);
  EXPECT_LE(terrain.surface.vertices.size(), 900u);
  EXPECT_EQ(facing_down(terrain), 0u);
}

#endif

}  // namespace
}  // namespace clast
