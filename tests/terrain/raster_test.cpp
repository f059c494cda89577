// Rasters as ground.
#include <gtest/gtest.h>

#include <cmath>

#include "core/files/text_file.hpp"
#include "tests/terrain/geotiff_bytes.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

class RasterGround : public testing::Test {
 protected:
  std::filesystem::path asc(int columns, int rows, const std::function<double(double, double)>& z,
                            double west = 0.0, double south = 0.0, double cell = 1.0) {
    write_asc(folder_ / "dem.asc", columns, rows, west, south, cell, z);
    return folder_ / "dem.asc";
  }
  /// A raster described by a VRT over raw little-endian floats (north row first).
  std::filesystem::path vrt(const std::string& head, const std::vector<float>& rows, int columns,
                            int bands = 1) {
    const std::string bytes(reinterpret_cast<const char*>(rows.data()),
                            rows.size() * sizeof(float));
    write_text_file(folder_ / "raw.bin", bytes);
    const int height = static_cast<int>(rows.size()) / columns;
    std::string text = "<VRTDataset rasterXSize=\"" + std::to_string(columns) +
                       "\" rasterYSize=\"" + std::to_string(height) + "\">" + head;
    for (int band = 1; band <= bands; ++band) {
      text += "<VRTRasterBand dataType=\"Float32\" band=\"" + std::to_string(band) +
              "\" subClass=\"VRTRawRasterBand\"><SourceFilename relativeToVRT=\"1\">raw.bin"
              "</SourceFilename><ImageOffset>0</ImageOffset><PixelOffset>4</PixelOffset>"
              "<LineOffset>" +
              std::to_string(4 * columns) + "</LineOffset><ByteOrder>LSB</ByteOrder>" +
              "</VRTRasterBand>";
    }
    write_text_file(folder_ / "dem.vrt", text + "</VRTDataset>");
    return folder_ / "dem.vrt";
  }
  std::string refused(const std::filesystem::path& path) {
    return refusal(TerrainOptions{.surface = {path}});
  }
  const ScratchFolder folder_;
};

TEST_F(RasterGround, CellCentresCarryTheHeights) {
  const SlopedGround plane;
  const auto path = asc(
      5, 4, [&](double x, double y) { return plane.at(x, y); }, 10, -20, 2.5);
  const Terrain terrain = read_terrain({.surface = {path}});
  EXPECT_EQ(terrain.surface.vertices.size(), 20u);
  EXPECT_EQ(terrain.surface.triangles.size(), 2u * 4 * 3);
  EXPECT_EQ(terrain.report.boundary_edges, 2u * (4 + 3));
  EXPECT_EQ(facing_down(terrain), 0u);
  const Bounds box = bounds(terrain.surface);
  EXPECT_NEAR(box.low.x(), 11.25, 1e-12);
  EXPECT_NEAR(box.high.x(), 21.25, 1e-12);
  EXPECT_NEAR(box.low.y(), -18.75, 1e-12);
  EXPECT_NEAR(box.high.y(), -11.25, 1e-12);
  // GDAL holds an Esri grid as float.
  for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-5);
}

TEST_F(RasterGround, CellsWithoutHeightLeaveAHole) {
  const auto path =
      asc(6, 6, [](double x, double y) { return x == 2.5 && y == 3.5 ? -9999.0 : 50.0; });
  const Terrain terrain = read_terrain({.surface = {path}});
  EXPECT_EQ(terrain.surface.vertices.size(), 35u);
  EXPECT_EQ(terrain.surface.triangles.size(), 2u * (25 - 4));
  EXPECT_EQ(terrain.report.boundary_edges, 4u * 5 + 8);
  EXPECT_TRUE(contains(terrain.report.notes.front(), "1 of 36 cells have no height"));
}

TEST_F(RasterGround, ResolutionMakesItCoarserByMeans) {
  const SlopedGround plane;
  const auto path = asc(8, 8, [&](double x, double y) { return plane.at(x, y); });
  const Terrain terrain = read_terrain({.surface = {path}, .resolution = 2.0});
  EXPECT_EQ(terrain.surface.vertices.size(), 16u);
  for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-5);
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {path}, .resolution = 0.5}),
                       "finer than the raster"));
}

TEST_F(RasterGround, RowsThatRunNorthAreTurnedOver) {
  const std::vector<float> rows = {0, 1, 2, 10, 11, 12};  // the first row is the southern one
  const Terrain terrain = read_terrain(
      {.surface = {vrt("<GeoTransform>100, 2, 0, 200, 0, 2</GeoTransform>", rows, 3)}});
  ASSERT_EQ(terrain.surface.vertices.size(), 6u);
  for (const Vec3& v : terrain.surface.vertices) {
    EXPECT_EQ(v.z(), (v.x() - 101.0) / 2.0 + 10.0 * (v.y() - 201.0) / 2.0);
  }
  EXPECT_EQ(facing_down(terrain), 0u);
}

// GDAL finds a row of a text grid by way of the rows before it; read from the south, a file that
// was cut after a few of many rows took for ever.
TEST_F(RasterGround, TextGridCutShortIsRefusedAtOnce) {
  const auto path = asc(50, 200, [](double x, double y) { return x + y; });
  const std::string whole = read_text_file(path);
  for (const double share : {0.1, 0.5, 0.9}) {
    write_text_file(
        path, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    EXPECT_TRUE(contains(refused(path), "cut short")) << share;
  }
}

TEST_F(RasterGround, WithoutGeoreferenceItIsRefusedWithAWayOut) {
  const std::filesystem::path file = vrt("", {3, 4, 5, 0, 1, 2}, 3);
  EXPECT_EQ(refusal(TerrainOptions{.surface = {file}}),
            file.string() +
                ": has no georeference, so its position and cell size are unknown; give it one "
                "(gdal_translate -a_ullr WEST NORTH EAST SOUTH -a_srs EPSG:CODE)");
}

TEST_F(RasterGround, MapSystemIsCarriedThroughAsItsCode) {
  const Terrain terrain =
      read_terrain({.surface = {vrt("<SRS>EPSG:2154</SRS><GeoTransform>652000, 1, 0, 6203000, 0, -1"
                                    "</GeoTransform>",
                                    {1, 2, 3, 4}, 2)}});
  EXPECT_EQ(terrain.frame.crs, "EPSG:2154");
  EXPECT_EQ(terrain.frame.origin, Vec3(652001, 6202999, 0));
  const Bounds box = bounds(terrain.surface);
  EXPECT_EQ(terrain.frame.to_map(box.low), Vec3(652000.5, 6202998.5, 1));
}

// A height system beside the map system changes nothing but must be in metres.
TEST_F(RasterGround, HeightSystemsAreLeftOutAndFeetRefused) {
  const std::string place = "<GeoTransform>652000, 1, 0, 5203000, 0, -1</GeoTransform>";
  const std::vector<float> four = {1, 2, 3, 4};
  const Terrain metres =
      read_terrain({.surface = {vrt("<SRS>EPSG:32632+5783</SRS>" + place, four, 2)}});
  EXPECT_EQ(metres.frame.crs, "EPSG:32632");
  const std::string feet = refused(vrt("<SRS>EPSG:32632+8228</SRS>" + place, four, 2));
  EXPECT_TRUE(contains(feet, "dem.vrt: its heights are in units of the foot (0.3048 m)")) << feet;
  vrt(place, four, 2);
  std::string text = read_text_file(folder_ / "dem.vrt");
  text.insert(text.find("<SourceFilename"), "<UnitType>US survey foot</UnitType>");
  write_text_file(folder_ / "dem.vrt", text);
  EXPECT_TRUE(contains(refused(folder_ / "dem.vrt"), "its heights are in feet (unit \"US survey"));
}

TEST_F(RasterGround, NumbersThatStandForNoDataUndeclaredAreRefused) {
  const std::string place = "<GeoTransform>0, 1, 0, 3, 0, -1</GeoTransform>";
  for (const float value : {-9999.0f, -32768.0f, 3e38f, -3.4e38f, 1e20f}) {
    const std::string message = refused(vrt(place, {5, 5, 5, 5, value, 5, 5, 5, 5}, 3));
    EXPECT_TRUE(contains(message, "dem.vrt: the height at x 1.500, y 1.500, z ")) << message;
    EXPECT_TRUE(contains(message, "gdal_translate -a_nodata ")) << message;
  }
  EXPECT_EQ(refused(vrt(place, {5, 5, 5, 5, 8849, 5, 5, 5, 5}, 3)), "") << "a mountain or a spike";
}

TEST_F(RasterGround, WhatIsNoHeightRasterIsRefused) {
  const std::vector<float> four = {1, 2, 3, 4};
  EXPECT_TRUE(contains(
      refused(vrt("<GeoTransform>0, 0.8, 0.6, 0, 0.6, -0.8</GeoTransform>", four, 2)), "rotated"));
  EXPECT_TRUE(contains(
      refused(
          vrt("<SRS>EPSG:4326</SRS><GeoTransform>5, 0.1, 0, 47, 0, -0.1</GeoTransform>", four, 2)),
      "degrees"));
  EXPECT_TRUE(contains(refused(vrt("<SRS>EPSG:2227</SRS><GeoTransform>0, 1, 0, 0, 0, -1"
                                   "</GeoTransform>",
                                   four, 2)),
                       "map unit"));
  EXPECT_TRUE(contains(refused(vrt("", four, 2, 3)), "3 bands"));
  EXPECT_TRUE(contains(refused(vrt("<GeoTransform>0, 1, 0, 1, 0, -1</GeoTransform>", {1, 2, 3}, 3)),
                       "3 x 1 cells"));
  EXPECT_TRUE(contains(refused(asc(4, 4, [](double, double) { return -9999.0; })),
                       "holds no heights, only nodata"));
  EXPECT_TRUE(contains(refused(vrt("<GeoTransform>2, -1, 0, 2, 0, -1</GeoTransform>", four, 2)),
                       "columns must run east"));
  write_text_file(folder_ / "scene.nc", "CDF");
  EXPECT_TRUE(contains(refused(folder_ / "scene.nc"), "gdal_translate scene.nc ground.tif"));
  write_text_file(folder_ / "empty.tif", "");
  EXPECT_TRUE(contains(refused(folder_ / "empty.tif"), "empty.tif: is not a raster"));
  const auto path = asc(3, 3, [](double, double) { return 1.0; });
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {path}, .up = "y"}), "z up"));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {path, path}}), "one raster"));
}

TEST_F(RasterGround, UnitsOfTheBandAreMetresOrRefused) {
  const std::string place = "<GeoTransform>652000, 1, 0, 5203000, 0, -1</GeoTransform>";
  const auto refused_unit = [&](const std::string& unit) {
    vrt(place, {1, 2, 3, 4}, 2);
    std::string text = read_text_file(folder_ / "dem.vrt");
    text.insert(text.find("<SourceFilename"), "<UnitType>" + unit + "</UnitType>");
    write_text_file(folder_ / "dem.vrt", text);
    return refused(folder_ / "dem.vrt");
  };
  for (const char* unit : {"", "m", "M", "metre", "meters", "Metres", "[m]", "m a.s.l.", "(m)",
                           "m.a.s.l.", "metre (EGM96 geoid)", "unknown", "none", "1"}) {
    EXPECT_EQ(refused_unit(unit), "") << unit;
  }
  const std::vector<std::pair<const char*, const char*>> others = {
      {"ft", "A*0.3048 "},
      {"foot", "A*0.3048 "},
      {"feet", "A*0.3048 "},
      {"US survey foot", "feet"},
      {"ftUS", "A*0.3048006096"},
      {"[ft]", "A*0.3048 "},
      {"international feet", "feet"},
      {"dm", "in dm (unit \"dm\")"},
      {"cm", "A*0.01 "},
      {"mm", "A*0.001 "},
      {"km", "A*1000 "},
      {"centimetres", "A*0.01 "},
      {"Millimeter", "A*0.001 "},
      {"decimeter", "A*0.1 "},
      {"inch", "A*0.0254 "},
      {"yards", "A*0.9144 "},
      {"furlong", "the unit \"furlong\", which is unknown"},
      {"degree",
       "\"degree\", which is unknown; convert them to metres, or if they are in metres, set the "
       "unit "
       "(gdal_edit.py -units m dem.vrt)"}};
  for (const auto& [unit, part] : others) {
    const std::string message = refused_unit(unit);
    EXPECT_TRUE(contains(message, "dem.vrt: its heights are in ")) << unit;
    EXPECT_TRUE(contains(message, part)) << unit;
  }
}

TEST_F(RasterGround, HeightsInFeetByAnOldProjectionFileAreRefused) {
  const auto path = asc(
      4, 4, [](double x, double) { return x - 500000; }, 500000, 4400000);
  for (const auto& [unit, part] :
       {std::pair("FEET", "its heights are in feet (unit \"feet\")"), {"METERS", ""}, {"NO", ""}}) {
    write_text_file(folder_ / "dem.prj",
                    "Projection    UTM\nZone          13\nDatum         NAD83\nZunits        " +
                        std::string(unit) + "\nUnits         METERS\nParameters\n");
    if (*part) {
      EXPECT_TRUE(contains(refused(path), part));
    } else {
      EXPECT_EQ(refused(path), "");
    }
  }
}

// What GDAL makes of the keys is not always what they say: it takes the first of these for metres.
TEST_F(RasterGround, KeysOfATiffInFeetOrContradictionAreRefused) {
  const auto refused_keys = [&](const std::vector<TiffKey>& keys) {
    std::vector<float> heights;
    for (int k = 0; k < 16; ++k) heights.push_back(100.0f + 0.25f * static_cast<float>(k));
    write_text_file(folder_ / "a.tif", geotiff(keys, 4, heights, 500000, 4400000));
    return refused(folder_ / "a.tif");
  };
  const std::vector<std::vector<TiffKey>> feet = {
      {{1024, 1}, {3072, 32767}, {3076, 9003}},
      {{1024, 1}, {3072, 26913}, {4096, 5703}, {4099, 9003}},
      {{1024, 1}, {3072, 26913}, {4096, 5103}, {4099, 9002}},
      {{1024, 1}, {3072, 2232}, {3076, 9001}},
      {{1024, 1}, {3072, 26913}, {3076, 9003}},
      {{1024, 1}, {3072, 26913}, {4099, 9003}},
      {{1024, 1}, {3072, 26913}, {4096, 6360}},
      {{1024, 1}, {3072, 26913}, {4096, 32767}, {4099, 9002}},
      {{1024, 1}, {3072, 2232}},
      {{1024, 1}, {2048, 4269}, {3072, 32767}, {3074, 32767}, {3075, 1}, {3076, 9003}},
      {{3076, 9003}},
      {{4099, 9003}}};
  for (const std::vector<TiffKey>& keys : feet) {
    EXPECT_TRUE(contains(refused_keys(keys), "foot"))
        << keys.back().key << " " << keys.back().value;
  }
  for (const std::vector<TiffKey>& keys : std::vector<std::vector<TiffKey>>{
           {{1024, 1}, {3072, 26913}},
           {{1024, 1}, {3072, 26913}, {3076, 9001}},
           {{1024, 1}, {3072, 26913}, {4096, 5703}},
           {{1024, 1}, {3072, 26913}, {4096, 5703}, {4099, 9001}},
           {{1024, 1}, {2048, 4269}, {3072, 32767}, {3074, 32767}, {3075, 1}, {3076, 9001}}}) {
    EXPECT_EQ(refused_keys(keys), "") << keys.back().key << " " << keys.back().value;
  }
  EXPECT_TRUE(contains(refused_keys({{1024, 2}, {2048, 4326}}), "degrees"));
}

TEST_F(RasterGround, MapsThatStretchLengthsAreRefusedWithTheirScale) {
  const auto refused_in = [&](const std::string& system, const char* corner) {
    return refused(vrt("<SRS>" + system + "</SRS><GeoTransform>" + corner + "</GeoTransform>",
                       {1, 2, 3, 4}, 2));
  };
  const char* alps = "1147666, 1, 0, 5903972, 0, -1";
  for (const char* system : {"EPSG:3857", "EPSG:3395", "EPSG:4087", "ESRI:102100", "ESRI:54009"}) {
    const std::string message = refused_in(system, alps);
    EXPECT_TRUE(contains(message, "dem.vrt: lengths on its map (")) << system;
    EXPECT_TRUE(contains(message,
                         "project it to a local system in metres first (gdalwarp -t_srs "
                         "EPSG:326"));
  }
  EXPECT_EQ(refused_in("EPSG:32632", "652000, 1, 0, 5203000, 0, -1"), "");
  EXPECT_EQ(refused_in("EPSG:3035", "4321000, 1, 0, 2600000, 0, -1"), "");
  EXPECT_EQ(refused_in("EPSG:3857", "1147666, 1, 0, 2000, 0, -1"), "") << "at the equator";
}

/// Where fill lies in a grid of 24 x 20 cells.
const std::vector<std::pair<const char*, std::function<bool(int, int)>>>& fill_shapes() {
  static const std::vector<std::pair<const char*, std::function<bool(int, int)>>> kShapes = {
      {"rim", [](int i, int j) { return i < 3 || j < 2 || i > 21 || j > 17; }},
      {"side", [](int i, int) { return i < 3; }},
      {"corner", [](int i, int j) { return i + j < 12; }},
      {"block", [](int i, int j) { return i >= 8 && i < 13 && j >= 6 && j < 9; }},
      {"single cells", [](int i, int j) { return (i * 7 + j * 11) % 29 == 0; }}};
  return kShapes;
}

// Every fill value that lies off the ground is refused, or, where the file declares another one,
// named with its count.
TEST_F(RasterGround, FillValuesThatStandOutAreRefusedOrCounted) {
  const auto grid = [&](double fill, const std::function<bool(int, int)>& filled, double cell,
                        double base, bool declared) {
    std::string text = "ncols 24\nnrows 20\nxllcorner 600000\nyllcorner 5180000\ncellsize " +
                       std::to_string(cell) + "\n" + (declared ? "NODATA_value -32768\n" : "");
    std::size_t count = 0;
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 24; ++i) {
        const bool none = filled(i, j);
        count += none;
        const double ground = base - 0.4 * cell * j + 0.1 * cell * std::sin(i) + 0.05 * cell * i;
        text += std::to_string(none ? fill : ground) + " ";
      }
      text += "\n";
    }
    write_text_file(folder_ / "dem.asc", text);
    return count;
  };
  for (const double fill : {0.0, -1.0 * 99, -99.99, -100.0, -500.0, -999.0, -999.9, -1000.0,
                            -9999.0, -9999.9, 9999.0, -10000.0, -32767.0, 99999.0, 1e20}) {
    for (const auto& [shape, filled] : fill_shapes()) {
      for (const double cell : {0.5, 5.0, 50.0}) {
        SCOPED_TRACE(shape + std::string(" of ") + std::to_string(fill));
        grid(fill, filled, cell, 1500.0, false);
        const std::string message = refused(folder_ / "dem.asc");
        EXPECT_TRUE(
            contains(message, "stands for no data, declare it first: gdal_translate -a_nodata "));
        const std::size_t count = grid(fill, filled, cell, 1500.0, true);
        const bool impossible = std::abs(fill) > 12000.0 || fill == -9999.0;
        if (impossible || fill == -32768.0) continue;
        const Terrain terrain = read_terrain({.surface = {folder_ / "dem.asc"}});
        EXPECT_TRUE(contains(terrain.report.notes.front(),
                             ": " + std::to_string(count) + " cells have the height "));
      }
    }
  }
}

TEST_F(RasterGround, SeaLakesBenchesAndLowlandAreNoFill) {
  const auto notes = [&](const std::function<double(double, double)>& z) {
    const Terrain terrain = read_terrain({.surface = {asc(24, 20, z, 600000, 5180000, 2.0)}});
    std::string all;
    for (const std::string& note : terrain.report.notes) all += note + "\n";
    return all.find("stands for no data") == std::string::npos ? "" : all;
  };
  const auto slope = [](double x, double y) { return 0.4 * (x - 600000) + 0.3 * (y - 5180000); };
  EXPECT_EQ(notes([&](double x, double y) { return std::max(0.0, slope(x, y) - 8.0); }), "")
      << "sea";
  EXPECT_EQ(notes([&](double x, double y) { return std::max(562.3, 550.0 + slope(x, y)); }), "")
      << "a lake";
  EXPECT_EQ(notes([&](double x, double y) { return slope(x, y) - 15.0; }), "") << "below the sea";
  EXPECT_EQ(notes([&](double, double) { return 0.0; }), "") << "a plane";
  EXPECT_EQ(notes([&](double x, double y) { return 990.0 + std::round(slope(x, y)); }), "")
      << "whole metres, 999 among them";
  EXPECT_EQ(notes([&](double x, double) { return x < 600012 ? 0.0 : 0.5 * (x - 600012); }), "")
      << "a floor";
}

// A row that begins with "nan" counts, wherever it stands, and the system beside the file too.
TEST_F(RasterGround, EsriGridsMayBeginWithWordsForNoHeight) {
  const std::string head = "ncols 5\nnrows 4\nxllcorner 600000\nyllcorner 5180000\ncellsize 1\n";
  for (const char* none :
       {"nan", "NaN", "NAN", "-nan", "nan(ind)", "-1.#IND", "1.#QNAN", "inf", "-9999"}) {
    for (const char* nodata : {"", "NODATA_value -9999\n", "nodata_value nan\n"}) {
      if (std::string(none) == "-9999" && std::string(nodata) != "NODATA_value -9999\n") continue;
      for (const int gap : {0, 1, 2, 3}) {  // the row that begins without a height
        std::string text = head + nodata;
        for (int j = 0; j < 4; ++j) {
          for (int i = 0; i < 5; ++i) {
            text +=
                (j == gap && i == 0 ? none : std::to_string(1000 - 2 * j + i)) + std::string(" ");
          }
          text += "\n";
        }
        write_text_file(folder_ / "dem.asc", text);
        write_text_file(
            folder_ / "dem.prj",
            R"(PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]])");
        SCOPED_TRACE(text);
        const Terrain terrain = read_terrain({.surface = {folder_ / "dem.asc"}});
        EXPECT_TRUE(contains(terrain.frame.crs, "UTM zone 32N"));
        // Beside a gap within a side, the corner of the grid belongs to no square.
        EXPECT_EQ(terrain.surface.vertices.size(), gap == 0 || gap == 3 ? 19u : 18u);
        for (const Vec3& v : terrain.surface.vertices) {
          const Vec3 p = terrain.frame.to_map(v) - Vec3(600000.5, 5180000.5, 0);
          EXPECT_NEAR(p.z(), 1000 - 2 * (3 - p.y()) + p.x(), 1e-9);
        }
      }
    }
  }
  for (const char* word : {"NA", "null", "*", "-", "#N/A", "novalue"}) {
    write_text_file(folder_ / "dem.asc",
                    head + "1 2 3 4 5\n1 2 " + word + " 4 5\n1 2 3 4 5\n1 2 3 4 5\n");
    EXPECT_TRUE(contains(
        refused(folder_ / "dem.asc"),
        "dem.asc: line 7: \"" + std::string(word) + "\" is not a height; write the NODATA_value"));
  }
}

TEST_F(RasterGround, RasterCutShortIsRefused) {
  const auto path = asc(20, 20, [](double x, double y) { return x + y; });
  const std::string text = read_text_file(path);
  write_text_file(path, text.substr(0, text.size() / 2));
  EXPECT_TRUE(contains(refused(path), "can't be read"));
}

}  // namespace
}  // namespace clast
