// Ground zones from names, rasters and polygons.
#include <gtest/gtest.h>

#include "core/text_file.hpp"
#include "terrain/terrain_file.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

double level(double, double) { return 5.0; }

std::string box_feature(const std::string& zone, double x0, double y0, double x1, double y1) {
  std::string corners;
  for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}}) {
    corners += (corners.empty() ? "[" : ",[") + std::to_string(x) + "," + std::to_string(y) + "]";
  }
  return R"({"type":"Feature","properties":{"zone":")" + zone +
         R"("},"geometry":{"type":"Polygon","coordinates":[[)" + corners + "]]}}";
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

class Zones : public testing::Test {
 protected:
  void SetUp() override { write_mesh(ground_, squares(10, 1.0, level)); }

  Terrain read(const std::vector<std::string>& zones) {
    return read_terrain({.surface = {ground_}, .zones = zones});
  }
  std::string refused(const std::vector<std::string>& zones) {
    return refusal(TerrainOptions{.surface = {ground_}, .zones = zones});
  }
  std::string geojson(const std::string& features) {
    write_text_file(folder_ / "zones.geojson", collection(features));
    return folder_ / "zones.geojson";
  }
  std::string raster(const std::function<double(double, double)>& value) {
    write_asc(folder_ / "zones.asc", 10, 10, 0.0, 0.0, 1.0, value);
    return folder_ / "zones.asc";
  }
  /// Every triangle must have the zone that `expected` names over its centroid.
  static void expect_zones(const Terrain& terrain,
                           const std::function<std::string(double, double)>& expected) {
    ASSERT_EQ(terrain.zone.size(), terrain.surface.triangles.size());
    for (std::size_t t = 0; t < terrain.zone.size(); ++t) {
      const auto& [a, b, c] = terrain.surface.triangles[t];
      const std::vector<Vec3>& v = terrain.surface.vertices;
      const Vec3 centroid = terrain.frame.map((v[a] + v[b] + v[c]) / 3.0);
      EXPECT_EQ(terrain.zone_names.at(terrain.zone[t]), expected(centroid.x(), centroid.y()))
          << centroid.transpose();
    }
  }

  const ScratchFolder folder_;
  const std::filesystem::path ground_ = folder_ / "ground.ply";
};

TEST_F(Zones, ANamePerFileInOrderAndTheSameNameIsTheSameZone) {
  std::vector<std::filesystem::path> files;
  for (int k = 0; k < 3; ++k) {
    TriangleMesh mesh = squares(1, 2.0, level);
    for (Vec3& v : mesh.vertices) v.x() += 2.0 * k;
    files.push_back(folder_ / ("part" + std::to_string(k) + ".ply"));
    write_mesh(files.back(), mesh);
  }
  const Terrain terrain = read_terrain({.surface = files, .zones = {"rock", "grass", "rock"}});
  EXPECT_EQ(terrain.zone_names, (std::vector<std::string>{"rock", "grass"}));
  EXPECT_EQ(terrain.zone, (std::vector<std::uint16_t>{0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(terrain.report.components, 1u) << "files are welded along their borders";
  EXPECT_EQ(terrain.report.boundary_edges, 8u);

  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = files, .zones = {"rock", "grass"}}),
                       "2 names for 3 surface files"));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = files, .zones = {"a", "", "b"}}),
                       "an empty name"));
  const std::vector<std::filesystem::path> twice = {files[0], files[0]};
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = twice, .zones = {"a", "b"}}),
                       "under different zones"));
  EXPECT_EQ(read_terrain({.surface = twice, .zones = {"a", "a"}}).report.dropped_duplicates, 2u);
}

TEST_F(Zones, ARasterGivesClassNumbersOrTheNamesWrittenBehindIt) {
  const std::string file = raster([](double x, double y) {
    return x < 4.0 ? 3.0 : y < 6.0 ? 1.0 : 7.0;
  });
  expect_zones(read({file}), [](double x, double y) {
    return x < 4.0 ? "3" : y < 6.0 ? "1" : "7";
  });
  const Terrain named = read({file + ":1=grass,3=rock,7=grass,9=water"});
  EXPECT_EQ(named.zone_names, (std::vector<std::string>{"grass", "rock"}));
  expect_zones(named, [](double x, double) { return x < 4.0 ? "rock" : "grass"; });
  // The command line cuts lists at commas.
  expect_zones(read({file + ":1=grass", "3=rock", "7=grass"}),
               [](double x, double) { return x < 4.0 ? "rock" : "grass"; });
}

TEST_F(Zones, RastersThatDoNotFitAreRefused) {
  EXPECT_TRUE(contains(refused({(folder_ / "none.asc").string()}), "none.asc: no such file"));
  const std::string file = raster([](double x, double) { return x < 4.0 ? 3.0 : 1.0; });
  EXPECT_TRUE(contains(refused({file + ":1=grass"}), "class 3"));
  EXPECT_TRUE(contains(refused({file + ":1=grass,x=rock"}), "is not CLASS=NAME"));
  EXPECT_TRUE(contains(refused({file + ":1=grass,1=rock"}), "class 1 is named twice"));
  EXPECT_TRUE(
      contains(refused({raster([](double x, double) { return x; })}), "whole class numbers"));
  const std::string holed =
      refused({raster([](double x, double y) { return x > 8.0 && y > 9.0 ? -9999.0 : 2.0; })});
  EXPECT_TRUE(contains(holed, "leaves 4 of 200 triangles (2.0"));
  EXPECT_TRUE(contains(holed, "x 8."));
}

TEST_F(Zones, PolygonsDecideByTheCentroidOfATriangle) {
  // Borders on grid lines, shared by both polygons; a hole in one is filled by the third.
  const std::string holed =
      R"({"type":"Feature","properties":{"zone":"rock"},"geometry":{"type":"Polygon","coordinates":[)"
      R"([[0,0],[6,0],[6,10],[0,10],[0,0]],[[2,2],[4,2],[4,5],[2,5],[2,2]]]}})";
  const Terrain terrain = read({geojson(holed + "," + box_feature("grass", 6, 0, 10, 10) + "," +
                                        box_feature("scree", 2, 2, 4, 5))});
  EXPECT_EQ(terrain.zone_names, (std::vector<std::string>{"rock", "grass", "scree"}));
  expect_zones(terrain, [](double x, double y) {
    if (x > 6.0) return "grass";
    return x > 2.0 && x < 4.0 && y > 2.0 && y < 5.0 ? "scree" : "rock";
  });
}

// Borders through the centroids of triangles: each must be in one of the two polygons only.
TEST_F(Zones, ACentroidOnASharedBorderIsInOnePolygon) {
  const double third = 5.0 + 1.0 / 3.0;
  const Terrain terrain =
      read({geojson(box_feature("a", 0, 0, third, 10) + "," + box_feature("b", third, 0, 10, 10))});
  EXPECT_EQ(terrain.zone_names.size(), 2u);
}

TEST_F(Zones, MultiPolygonsAreOneZone) {
  const std::string both =
      R"({"type":"Feature","properties":{"zone":"a"},"geometry":{"type":"MultiPolygon","coordinates":)"
      R"([[[[0,0],[3,0],[3,10],[0,10],[0,0]]],[[[7,0],[10,0],[10,10],[7,10],[7,0]]]]}})";
  expect_zones(read({geojson(both + "," + box_feature("b", 3, 0, 7, 10))}),
               [](double x, double) { return x < 3.0 || x > 7.0 ? "a" : "b"; });
}

/// A GeoTIFF of 4 x 4 cells of 100 m around a place in a coordinate system.
void write_map_raster(const std::filesystem::path& path, const Vec2& middle,
                      const std::string& crs) {
  TriangleMesh mesh = squares(4, 100.0, level);
  for (Vec3& v : mesh.vertices) v += Vec3(middle.x() - 200.0, middle.y() - 200.0, 0.0);
  Terrain terrain;
  terrain.surface = mesh;
  terrain.frame.crs = crs;
  export_terrain(path, terrain, "z", 100.0);
}

// Lambert-93 puts E 700 km on the meridian of 3 degrees east and N 6,600 km on the parallel of 46.5
// degrees, by definition. GeoJSON without a system is in degrees (RFC 7946).
TEST_F(Zones, PolygonsInDegreesAreProjectedToTheMapOfTheGround) {
  write_map_raster(folder_ / "dem.tif", {700000.0, 6600000.0}, "EPSG:2154");
  const Terrain terrain =
      read_terrain({.surface = {folder_ / "dem.tif"},
                    .zones = {geojson(box_feature("west", 2.9, 46.4, 3.0, 46.6) + "," +
                                      box_feature("east", 3.0, 46.4, 3.1, 46.6))}});
  EXPECT_EQ(terrain.zone_names, (std::vector<std::string>{"west", "east"}));
  expect_zones(terrain, [](double x, double) { return x < 700000.0 ? "west" : "east"; });
  // Numbers beyond degrees are map metres, whatever the format says.
  EXPECT_EQ(refusal(TerrainOptions{
                .surface = {folder_ / "dem.tif"},
                .zones = {geojson(box_feature("all", 699000, 6599000, 701000, 6601000))}}),
            "");
}

TEST_F(Zones, AZoneRasterOfAnotherMapSystemIsRefused) {
  write_map_raster(folder_ / "dem.tif", {700000.0, 6600000.0}, "EPSG:2154");
  write_map_raster(folder_ / "zones.tif", {700000.0, 6600000.0}, "EPSG:32631");
  const std::string message = refusal(TerrainOptions{.surface = {folder_ / "dem.tif"},
                                                     .zones = {(folder_ / "zones.tif").string()}});
  EXPECT_TRUE(contains(message, "is in EPSG:32631, the ground in EPSG:2154"));
}

TEST_F(Zones, PolygonsThatDoNotFitAreRefused) {
  const std::string overlap =
      refused({geojson(box_feature("a", 0, 0, 6, 10) + "," + box_feature("b", 5, 0, 10, 10))});
  EXPECT_TRUE(contains(overlap, "zones \"a\" and \"b\" overlap at x 5."));
  EXPECT_EQ(
      refused({geojson(box_feature("a", 0, 0, 6, 10) + "," + box_feature("a", 5, 0, 10, 10))}), "");
  const std::string bare = refused({geojson(box_feature("a", 0, 0, 10, 9))});
  EXPECT_TRUE(contains(bare, "leaves 20 of 200 triangles (10.0"));
  EXPECT_TRUE(contains(bare, "y 9."));
  EXPECT_TRUE(contains(refused({geojson("")}), "zones.geojson"));
  EXPECT_TRUE(contains(refused({geojson(R"({"type":"Feature","properties":{"zone":"a"},)"
                                        R"("geometry":{"type":"Point","coordinates":[1,1]}})")}),
                       "zones must be polygons"));
  EXPECT_TRUE(contains(refused({geojson(R"({"type":"Feature","properties":{"kind":"a"},)"
                                        R"("geometry":{"type":"Point","coordinates":[1,1]}})")}),
                       "no property \"zone\" (there are: kind)"));
  EXPECT_TRUE(contains(refused({geojson(box_feature("", 0, 0, 10, 10))}), "empty property"));
  write_text_file(folder_ / "bad.geojson", "{ not json");
  EXPECT_TRUE(contains(refused({(folder_ / "bad.geojson").string()}), "bad.geojson"));
  EXPECT_TRUE(contains(refused({geojson(box_feature("a", 0, 0, 10, 10)) + ":1=rock"}),
                       "leave \"1=rock\" out"));
}

}  // namespace
}  // namespace clast
