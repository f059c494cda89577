// Ground zones from names, rasters and polygons.
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <map>

#include "core/files/text_file.hpp"
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
      const Vec3 centroid = terrain.frame.to_map((v[a] + v[b] + v[c]) / 3.0);
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
  EXPECT_EQ(read_terrain({.surface = twice, .zones = {"a", "a"}}).report.removed_duplicates, 2u);
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
  EXPECT_TRUE(contains(holed, "leaves 4 of 200 triangles (2 m2"));
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
  EXPECT_EQ(message, (folder_ / "zones.tif").string() +
                         ": is in WGS 84 / UTM zone 31N (EPSG:32631), the ground in RGF93 v1 / "
                         "Lambert-93 (EPSG:2154); reproject one (gdalwarp "
                         "-t_srs)");
}

TEST_F(Zones, PolygonsThatDoNotFitAreRefused) {
  const std::string overlap =
      refused({geojson(box_feature("a", 0, 0, 6, 10) + "," + box_feature("b", 5, 0, 10, 10))});
  EXPECT_EQ(overlap,
            (folder_ / "zones.geojson").string() +
                ": zones \"a\" and \"b\" overlap on 10 m2 around x 5.500, y 5.000, z 0.000; cut "
                "one of the polygons");
  EXPECT_EQ(
      refused({geojson(box_feature("a", 0, 0, 5.004, 10) + "," + box_feature("b", 5, 0, 10, 10))}),
      "")
      << "4 mm are what digitising leaves";
  EXPECT_TRUE(contains(
      refused({geojson(R"({"type":"Feature","properties":{"zone":"a"},"geometry":{"type":)"
                       R"("Polygon","coordinates":[[[0,0],[10,10],[10,0],[0,10],[0,0]]]}})")}),
      "(zone \"a\") crosses itself"));
  EXPECT_EQ(refused({geojson(box_feature("a", 600, 0, 610, 10))}),
            (folder_ / "zones.geojson").string() +
                ": the zones lie at x 600 to 610, y 0 to 10, the ground at x 0 to 10, y 0 to 10; "
                "convert both to one map system (zones in z-up map coordinates)");
  EXPECT_EQ(
      refused({geojson(box_feature("a", 0, 0, 6, 10) + "," + box_feature("a", 5, 0, 10, 10))}), "");
  const std::string bare = refused({geojson(box_feature("a", 0, 0, 10, 9))});
  EXPECT_TRUE(contains(bare, "leaves 20 of 200 triangles (10 m2"));
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

TEST_F(Zones, BlanksAroundANameDoNotCount) {
  const Terrain terrain = read({geojson(box_feature(" loose rock ", 0, 0, 5, 10) + "," +
                                        box_feature("loose rock", 5, 0, 10, 10))});
  EXPECT_EQ(terrain.zone_names, std::vector<std::string>{"loose rock"});
  EXPECT_TRUE(contains(refused({geojson(box_feature("  ", 0, 0, 10, 10))}), "empty property"));
}

TEST_F(Zones, AFileOfAnotherKindIsNoNameOfAZone) {
  write_text_file(folder_ / "zones.kml", "<kml/>");
  const std::string message = refused({(folder_ / "zones.kml").string()});
  EXPECT_TRUE(contains(message, "zones.kml is not a file of zones")) << message;
  EXPECT_TRUE(contains(message, "ogr2ogr zones.gpkg zones.kml")) << message;
}

// QGIS keeps styles in a table of the same file; other layers with geometry are one too many.
TEST_F(Zones, TablesWithoutGeometryInAGeoPackageDoNotCount) {
  GDALAllRegister();
  const std::string path = (folder_ / "zones.gpkg").string();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  ASSERT_NE(driver, nullptr);
  GDALDataset* dataset = driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  dataset->CreateLayer("layer_styles", nullptr, wkbNone);
  const auto add = [&](const char* name) {
    OGRLayer* layer = dataset->CreateLayer(name, nullptr, wkbPolygon);
    OGRFieldDefn field("zone", OFTString);
    layer->CreateField(&field);
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("zone", "rock");
    OGRLinearRing ring;
    for (const auto& [x, y] : {std::pair{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}) {
      ring.addPoint(x, y);
    }
    OGRPolygon polygon;
    polygon.addRing(&ring);
    feature.SetGeometry(&polygon);
    EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  };
  add("ground");
  GDALClose(dataset);
  EXPECT_EQ(read({path}).zone_names, std::vector<std::string>{"rock"});

  dataset = static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr, nullptr, nullptr));
  add("older");
  GDALClose(dataset);
  EXPECT_TRUE(contains(refused({path}), "2 layers (ground, older); save the one"));
}

/// Plan area of every zone.
std::map<std::string, double> zone_areas(const Terrain& terrain) {
  std::map<std::string, double> areas;
  for (std::size_t t = 0; t < terrain.zone.size(); ++t) {
    areas[terrain.zone_names[terrain.zone[t]]] += std::abs(normal_of(terrain, t).z()) / 2.0;
  }
  return areas;
}

// What GIS draw with arcs: the quarter disc about (0, 0) of radius 8 has the area 16 pi.
TEST_F(Zones, CurvesOfAGeoPackageAreDrawnAsChords) {
  GDALAllRegister();
  const std::vector<std::pair<const char*, OGRwkbGeometryType>> discs = {
      {"CURVEPOLYGON (COMPOUNDCURVE ((0 0, 8 0), CIRCULARSTRING (8 0, 5.65685424949238 "
       "5.65685424949238, 0 8), (0 8, 0 0)))",
       wkbCurvePolygon},
      {"MULTISURFACE (CURVEPOLYGON (COMPOUNDCURVE ((0 0, 8 0), CIRCULARSTRING (8 0, "
       "5.65685424949238 5.65685424949238, 0 8), (0 8, 0 0))))",
       wkbMultiSurface}};
  for (const auto& [text, type] : discs) {
    const std::string path = (folder_ / "curves.gpkg").string();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    GDALDataset* dataset = driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
    OGRLayer* layer = dataset->CreateLayer("zones", nullptr, wkbUnknown);
    OGRFieldDefn field("zone", OFTString);
    layer->CreateField(&field);
    const auto add = [&](const char* zone, const char* wkt) {
      OGRGeometry* geometry = nullptr;
      ASSERT_EQ(OGRGeometryFactory::createFromWkt(wkt, nullptr, &geometry), OGRERR_NONE);
      OGRFeature feature(layer->GetLayerDefn());
      feature.SetField("zone", zone);
      feature.SetGeometryDirectly(geometry);
      ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    };
    add("disc", text);
    add("rest",
        "CURVEPOLYGON (COMPOUNDCURVE ((8 0, 10 0, 10 10, 0 10, 0 8), CIRCULARSTRING (0 8, "
        "5.65685424949238 5.65685424949238, 8 0)))");
    GDALClose(dataset);
    const Terrain terrain =
        read_terrain({.surface = {ground_}, .zones = {path}, .cut_zones = true});
    double disc = 0.0;
    for (std::size_t t = 0; t < terrain.zone.size(); ++t) {
      if (terrain.zone_names[terrain.zone[t]] == "disc") {
        disc += std::abs(normal_of(terrain, t).z()) / 2.0;
      }
    }
    EXPECT_NEAR(disc, 16.0 * std::acos(-1.0), 0.05) << text;
    std::filesystem::remove(path);
  }
}

// A triangle is half of a square from (i, j): its centroid is a third of the way, where a border at
// 0.4 has it on the other side; but the part left of x = 0.4 is 1 - 0.6^2 = 0.64 of a half square
// that is wide on the left, and 0.4^2 = 0.16 of one that is wide on the right.
TEST_F(Zones, TheLargerPartOfATriangleDecides) {
  const Terrain terrain =
      read({geojson(box_feature("a", 0, 0, 5.4, 10) + "," + box_feature("b", 5.4, 0, 10, 10))});
  expect_zones(terrain, [](double x, double y) {
    const bool wide_on_the_left = y - std::floor(y) > x - std::floor(x);
    return x < 5.0 || (x < 6.0 && wide_on_the_left) ? "a" : "b";
  });
  // The same border from a raster of fine cells.
  write_asc(folder_ / "fine.asc", 100, 100, 0.0, 0.0, 0.1,
            [](double x, double) { return x < 5.4 ? 1.0 : 2.0; });
  const Terrain by_raster = read({(folder_ / "fine.asc").string() + ":1=a,2=b"});
  EXPECT_EQ(by_raster.zone, terrain.zone);
}

TEST_F(Zones, BordersThatAreCutGiveZonesTheirExactArea) {
  const std::string circle = [] {
    std::string corners;
    for (int k = 0; k <= 40; ++k) {
      const double angle = 2.0 * kPi * (k % 40) / 40.0;
      corners += (k > 0 ? ",[" : "[") + std::to_string(5.03 + 3.1 * std::cos(angle)) + "," +
                 std::to_string(4.96 + 3.1 * std::sin(angle)) + "]";
    }
    return corners;
  }();
  const std::string outside =
      R"({"type":"Feature","properties":{"zone":"out"},"geometry":{"type":"Polygon","coordinates":[)"
      R"([[-1,-1],[11,-1],[11,11],[-1,11],[-1,-1]],[)" +
      circle + "]]}}";
  const std::string inside =
      R"({"type":"Feature","properties":{"zone":"in"},"geometry":{"type":"Polygon","coordinates":[[)" +
      circle + "]]}}";
  const std::string file = geojson(outside + "," + inside);
  const double wanted = 20.0 * 3.1 * 3.1 * std::sin(kPi / 20.0);  // a regular 40-gon
  const auto wavy = [](double x, double y) { return std::sin(x) + 0.5 * std::cos(y); };
  write_mesh(ground_, squares(10, 1.0, wavy));
  const Terrain terrain = read_terrain({.surface = {ground_}, .zones = {file}, .cut_zones = true});
  const std::map<std::string, double> areas = zone_areas(terrain);
  EXPECT_NEAR(areas.at("in"), wanted, 1e-4);
  EXPECT_NEAR(areas.at("out"), 100.0 - wanted, 1e-4);
  EXPECT_EQ(facing_down(terrain), 0u);
  // The ground is what it was: watertight, with every new vertex on the triangle that was there.
  const TerrainSurface before = make_terrain_surface(read_terrain({.surface = {ground_}}));
  const TerrainSurface after = make_terrain_surface(terrain);
  for (const Vec3& v : terrain.surface.vertices) {
    EXPECT_NEAR(v.z(), *before.height_at(v.x(), v.y(), v.z()), 1e-9);
  }
  for (double x = 0.05; x < 10.0; x += 0.37) {
    for (double y = 0.03; y < 10.0; y += 0.41) {
      EXPECT_NEAR(*after.height_at(x, y, 0.0), *before.height_at(x, y, 0.0), 1e-9);
    }
  }
  // Without cutting the area is that of whole triangles.
  EXPECT_GT(std::abs(zone_areas(read({file})).at("in") - wanted), 0.01);
  write_terrain(folder_ / "cut.h5", terrain);
  const Terrain back = read_terrain({.surface = {folder_ / "cut.h5"}});
  EXPECT_EQ(back.zone, terrain.zone);
  EXPECT_EQ(refusal(TerrainOptions{.surface = {ground_}, .cut_zones = true}),
            "cut_zones: only the borders of polygons can be cut into the ground; give a polygon "
            "file as zones");
}

TEST_F(Zones, RulesBySlopeAndHeight) {
  // Three strips of 4 m: level, at 45 degrees, and at 71.6 degrees.
  const auto stairs = [](double x, double) {
    return std::max(0.0, std::min(x, 8.0) - 4.0) + 3.0 * std::max(0.0, x - 8.0);
  };
  write_mesh(ground_, squares(12, 1.0, stairs));
  const std::vector<std::string> rules = {"rock=slope>60", "scree=height>2&slope>=30", "soil=else"};
  const Terrain terrain = read(rules);
  EXPECT_EQ(terrain.zone_names, (std::vector<std::string>{"rock", "scree", "soil"}));
  expect_zones(terrain, [](double x, double) {
    return x > 8.0 ? "rock" : x > 6.0 ? "scree" : "soil";
  });
  const std::map<std::string, double> areas = zone_areas(terrain);
  EXPECT_NEAR(areas.at("rock"), 48.0, 1e-9);
  EXPECT_NEAR(areas.at("scree"), 24.0, 1e-9);
  EXPECT_EQ(refused({"rock=slope>60", "scree=height>2&slope>=30"}),
            "the zone rules: leaves 144 of 288 triangles (72 m2 in plan) without a zone, "
            "the first at x 0.667, y 0.333, z 0.000; end them with NAME=else");
  EXPECT_TRUE(contains(refused({"rock=slope>steep"}), "\"rock=slope>steep\" is not a rule"));
  EXPECT_TRUE(
      contains(refused({"rock=aspect>60", "soil=else"}), "is not a rule; write for example"));
  EXPECT_TRUE(contains(refused({"rock=slope>60", "soil"}), "\"soil\" is not a rule"));
}

}  // namespace
}  // namespace clast
