// Point clouds as ground, and one plane in three forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <sstream>

#include "core/files/text_file.hpp"
#include "tests/support/declared_las.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

class CloudGround : public testing::Test {
 protected:
  std::filesystem::path cloud(const std::string& text, const std::string& name = "cloud.xyz") {
    write_text_file(folder_ / name, text);
    return folder_ / name;
  }
  std::string refused(const std::string& text) {
    return refusal(TerrainOptions{.surface = {cloud(text)}, .resolution = 1.0});
  }
  const ScratchFolder folder_;
};

/// Points at quarter and three quarters of 1 m cells: four per cell, their mean at its centre.
std::string plane_points(const SlopedGround& plane, int cells) {
  std::ostringstream text;
  text.precision(17);
  for (int j = 0; j < 2 * cells; ++j) {
    for (int i = 0; i < 2 * cells; ++i) {
      const double x = 0.25 + 0.5 * i, y = 0.25 + 0.5 * j;
      text << x << ' ' << y << ' ' << plane.at(x, y) << '\n';
    }
  }
  return text.str();
}

// The second and third form of a plane, against the formula that made it.
TEST_F(CloudGround, APlaneIsTheSameAsRasterTinAndCloud) {
  const SlopedGround plane;
  const auto z = [&](double x, double y) { return plane.at(x, y); };
  write_mesh(folder_ / "tin.ply", squares(9, 1.0, z));
  const Terrain tin = read_terrain({.surface = {folder_ / "tin.ply"}});
  const Terrain from_cloud =
      read_terrain({.surface = {cloud(plane_points(plane, 10))}, .resolution = 1.0});
  write_asc(folder_ / "dem.asc", 10, 10, 0.0, 0.0, 1.0, z);
  const Terrain from_raster = read_terrain({.surface = {folder_ / "dem.asc"}});

  for (const Vec3& v : tin.surface.vertices) EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-6);
  for (const Vec3& v : from_cloud.surface.vertices) {
    EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-6);
  }
  for (const Vec3& v : from_raster.surface.vertices) {
    EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-6);
  }
  // The same surface: heights and normals agree wherever all three are.
  const TerrainSurface surfaces[] = {make_terrain_surface(tin), make_terrain_surface(from_cloud),
                                     make_terrain_surface(from_raster)};
  for (double x = 0.5; x < 9.0; x += 0.31) {
    for (double y = 0.5; y < 9.0; y += 0.37) {
      for (const TerrainSurface& surface : surfaces) {
        EXPECT_NEAR(surface.height_at(x, y, 0.0).value_or(0.0), plane.at(x, y), 1e-6);
      }
    }
  }
  // 10 x 10 centres of cells of 1 m, for both.
  for (const Terrain* grid : {&from_cloud, &from_raster}) {
    EXPECT_EQ(grid->surface.vertices.size(), 100u);
    EXPECT_EQ(grid->surface.triangles.size(), 162u);
    const Bounds box = bounds(grid->surface);
    EXPECT_NEAR(box.low.x(), 0.5, 1e-12);
    EXPECT_NEAR(box.high.y(), 9.5, 1e-12);
  }
}

TEST_F(CloudGround, HeightIsTheMeanOverTheCell) {
  const auto path = cloud("0.1 0.1 1\n0.9 0.2 3\n0.5 0.5 8\n1.5 0.5 0\n0.5 1.5 0\n1.5 1.5 0\n");
  const Terrain terrain = read_terrain({.surface = {path}, .resolution = 1.0});
  ASSERT_EQ(terrain.surface.vertices.size(), 4u);
  EXPECT_EQ(terrain.surface.vertices[0], Vec3(0.5, 0.5, 4.0));
}

/// The points of a 20 x 20 m plane, one per square metre, without those that `left_out` names.
std::string plane_without(const SlopedGround& plane,
                          const std::function<bool(int, int)>& left_out) {
  std::ostringstream text;
  text.precision(17);
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) {
      if (left_out(i, j)) continue;
      text << i + 0.5 << ' ' << j + 0.5 << ' ' << plane.at(i + 0.5, j + 0.5) << '\n';
    }
  }
  return text.str();
}

TEST_F(CloudGround, PinholesAreFilledAndAPlaneStaysOne) {
  const SlopedGround plane;
  const auto pinholes = [](int i, int j) { return i % 5 == 2 && (j % 5 == 2 || j % 5 == 3); };
  const Terrain terrain =
      read_terrain({.surface = {cloud(plane_without(plane, pinholes))}, .resolution = 1.0});
  EXPECT_EQ(terrain.surface.vertices.size(), 400u);
  for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-9);
  EXPECT_TRUE(contains(terrain.report.notes.at(1), "32 cells without points were filled"));
}

TEST_F(CloudGround, GapsStayOpen) {
  const auto pond = [](int i, int j) { return i >= 6 && i < 14 && j >= 6 && j < 14; };
  const Terrain terrain =
      read_terrain({.surface = {cloud(plane_without({}, pond))}, .resolution = 1.0});
  EXPECT_EQ(terrain.surface.vertices.size(), 400u - 64u);
  EXPECT_TRUE(contains(terrain.report.notes.at(1), "1 holes wider than 3 m were left open"));
  EXPECT_TRUE(contains(terrain.report.notes.at(1), "the widest, 8 m, around x 10.000, y 10.000"));
  EXPECT_TRUE(contains(terrain.report.notes.at(2), "64 of 400 cells have no height"));
}

TEST_F(CloudGround, HolesUpToTheAskedWidthAreFilledAndAPlaneStaysOne) {
  const SlopedGround plane;
  const auto pond = [](int i, int j) {
    return (i >= 2 && i < 7 && j >= 3 && j < 5) || (i >= 10 && i < 18 && j >= 6 && j < 14);
  };
  const auto path = cloud(plane_without(plane, pond));
  const Terrain all = read_terrain({.surface = {path}, .resolution = 1.0, .fill = 8.0});
  EXPECT_EQ(all.surface.vertices.size(), 400u);
  for (const Vec3& v : all.surface.vertices) EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-9);
  const Terrain some = read_terrain({.surface = {path}, .resolution = 1.0, .fill = 7.9});
  EXPECT_EQ(some.surface.vertices.size(), 400u - 64u);
  const Terrain none = read_terrain({.surface = {path}, .resolution = 1.0, .fill = 0.0});
  EXPECT_EQ(none.surface.vertices.size(), 400u - 64u - 10u);
}

// z = x^2 - y^2 has the mean of its four neighbours in every cell, so it is its own membrane.
TEST_F(CloudGround, AFilledHoleIsAMembrane) {
  std::ostringstream text;
  text.precision(17);
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) {
      const bool pond = (i - 10) * (i - 10) + (j - 9) * (j - 9) < 30;
      if (!pond) text << i + 0.5 << ' ' << j + 0.5 << ' ' << i * i - j * j << '\n';
    }
  }
  const Terrain terrain =
      read_terrain({.surface = {cloud(text.str())}, .resolution = 1.0, .fill = 12.0});
  ASSERT_EQ(terrain.surface.vertices.size(), 400u);
  for (const Vec3& v : terrain.surface.vertices) {
    const double i = v.x() - 0.5, j = v.y() - 0.5;
    EXPECT_NEAR(v.z(), i * i - j * j, 1e-9) << v.transpose();
  }
}

// Four heights per cell, as ranks: the percentile p of 0, 1, 2, 3 is 3 p / 100.
TEST_F(CloudGround, APercentileOfTheHeightsInACell) {
  std::string text;
  for (const char* corner : {"0.5 0.5", "1.5 0.5", "0.5 1.5", "1.5 1.5"}) {
    for (const char* height : {"3", "1", "0", "2"}) {
      text += std::string(corner) + " " + height + "\n";
    }
  }
  const auto path = cloud(text);
  for (const double percentile : {0.0, 10.0, 50.0, 75.0, 100.0}) {
    const Terrain terrain =
        read_terrain({.surface = {path}, .resolution = 1.0, .percentile = percentile});
    for (const Vec3& v : terrain.surface.vertices) {
      EXPECT_NEAR(v.z(), 3.0 * percentile / 100.0, 1e-12) << percentile;
    }
  }
}

// A thousand points in each cell, many more than the 64 that are kept of it, at heights that rise
// evenly from 0 to 1 along the file: an even sample of that is off by a step of it at most.
TEST_F(CloudGround, APercentileOfCrowdedCellsIsThatOfAnEvenSample) {
  std::ostringstream text;
  for (int k = 0; k < 1000; ++k) {
    const double height = (k + 0.5) / 1000.0;
    for (const char* corner : {"0.5 0.5", "1.5 0.5", "0.5 1.5", "1.5 1.5"}) {
      text << corner << ' ' << height << '\n';
    }
  }
  const auto path = cloud(text.str());
  for (const double percentile : {0.0, 20.0, 50.0, 90.0}) {
    const Terrain terrain =
        read_terrain({.surface = {path}, .resolution = 1.0, .percentile = percentile});
    for (const Vec3& v : terrain.surface.vertices) {
      EXPECT_NEAR(v.z(), percentile / 100.0, percentile == 0.0 ? 6e-4 : 1.0 / 64) << percentile;
    }
  }
}

TEST_F(CloudGround, OutliersAreLeftOutWithTheirNumberAndAPlace) {
  const SlopedGround plane;
  std::string text = plane_points(plane, 20);
  text += "3.5 3.5 20\n7.5 9.5 140\n7.6 9.5 139\n12.5 12.5 -50\n";
  const Terrain terrain =
      read_terrain({.surface = {cloud(text)}, .resolution = 1.0, .outliers = 3.0});
  EXPECT_EQ(terrain.surface.vertices.size(), 400u);
  for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-9);
  EXPECT_TRUE(contains(
      terrain.report.notes.at(1),
      "2 points more than 3 m below and 2 points above the surrounding ground were left out"));
  EXPECT_TRUE(contains(terrain.report.notes.at(1), "near x 12.500, y 12.500, z -50.000"));
  // They count where nothing is said.
  const Terrain all =
      read_terrain({.surface = {cloud(text)}, .resolution = 1.0, .spike_steepness = 0.0});
  EXPECT_LT(bounds(all.surface).low.z(), plane.at(20.0, 0.0) - 3.0);
}

TEST_F(CloudGround, OptionsOfCloudsAreRefusedWhenTheyAreNoneOrElsewhere) {
  const auto path = cloud("0 0 0\n");
  const auto refused_with = [&](const TerrainOptions& options) { return refusal(options); };
  EXPECT_TRUE(contains(refused_with({.surface = {path}, .percentile = 101.0}),
                       "percentile = 101: must be 0 (the lowest point), or from 1e-06 to 100"));
  EXPECT_TRUE(contains(refused_with({.surface = {path}, .outliers = 0.0}),
                       "outliers = 0: must be from 1e-06 to 100000 m"));
  EXPECT_TRUE(contains(refused_with({.surface = {path}, .fill = -1.0}),
                       "fill = -1: must be 0 (none is filled), or from 1e-06 to 1e+06 m"));
  write_mesh(folder_ / "tin.ply", squares(3, 1.0, [](double, double) { return 0.0; }));
  EXPECT_TRUE(contains(refused_with({.surface = {folder_ / "tin.ply"}, .percentile = 0.0}),
                       "tin.ply: percentile and outliers apply only to clouds; leave them out"));
}

TEST_F(CloudGround, TextInManyLayoutsIsRead) {
  const std::string heads[] = {"",    "X;Y;Z\n",   "# by hand\n\n", "\xEF\xBB\xBFx,y,z,red\n",
                               "4\n", "// x y z\n"};
  for (const std::string& head : heads) {
    const auto path = cloud(head + "0.5;0.5;1;255\r\n+1.5; 0.5;\t2;7\n0.5;1.5;3\n1.5e0;1.5;4");
    const Terrain terrain = read_terrain({.surface = {path}, .resolution = 1.0});
    ASSERT_EQ(terrain.surface.vertices.size(), 4u) << head;
    EXPECT_EQ(bounds(terrain.surface).high, Vec3(1.5, 1.5, 4)) << head;
  }
  const auto named =
      cloud("id,Z,Y,X\n9,1,0.5,0.5\n9,2,0.5,1.5\n9,3,1.5,0.5\n9,4,1.5,1.5\n", "named.csv");
  const Terrain terrain = read_terrain({.surface = {named}, .resolution = 1.0});
  EXPECT_EQ(bounds(terrain.surface).high, Vec3(1.5, 1.5, 4));
}

TEST_F(CloudGround, SeveralCloudsMakeOneGround) {
  const auto one = cloud("0.5 0.5 0\n1.5 0.5 0\n", "a.xyz");
  const auto two = cloud("0.5 1.5 0\n1.5 1.5 0\n", "b.xyz");
  const Terrain terrain = read_terrain({.surface = {one, two}, .resolution = 1.0});
  EXPECT_EQ(terrain.surface.triangles.size(), 2u);
  EXPECT_EQ(terrain.sources.size(), 2u);
  EXPECT_TRUE(contains(
      refusal(TerrainOptions{.surface = {one, two}, .zones = {"a", "b"}, .resolution = 1.0}),
      "several clouds form one grid"));
}

// 400 points on 10 x 10 m: four per square metre.
TEST_F(CloudGround, WithoutResolutionACellHoldsAboutFourPoints) {
  const Terrain terrain = read_terrain({.surface = {cloud(plane_points({}, 10))}});
  EXPECT_TRUE(contains(terrain.report.notes.front(), "400 points, mean heights over cells of 1 m"));
}

TEST_F(CloudGround, YUpCloudIsTurned) {
  const auto path = cloud("0.5 1 -0.5\n1.5 2 -0.5\n0.5 3 -1.5\n1.5 4 -1.5\n");
  const Terrain terrain = read_terrain({.surface = {path}, .up = "y", .resolution = 1.0});
  EXPECT_EQ(bounds(terrain.surface).high, Vec3(1.5, 1.5, 4));
}

TEST_F(CloudGround, PointsWithoutHeightAreLeftOutAndCounted) {
  const auto path = cloud("0.5 0.5 1\n1.5 0.5 2\n0.5 1.5 3\n1.5 1.5 4\n0.5 0.5 nan\n");
  const Terrain terrain = read_terrain({.surface = {path}, .resolution = 1.0});
  EXPECT_EQ(bounds(terrain.surface).low.z(), 1.0);
  EXPECT_TRUE(contains(terrain.report.notes.front(), "1 points without finite coordinates"));
}

/// Version 1.2, format 0, steps of a centimetre: four ground points and one of a tree over them.
/// @param keys  GeoTIFF key entries (key, 0, 1, value) of the map system; none: not named
std::string five_point_las(const std::vector<std::array<std::uint16_t, 4>>& keys = {}) {
  std::string las(227, '\0');
  const auto put = [&](std::size_t offset, auto value) {
    if (las.size() < offset + sizeof value) las.resize(offset + sizeof value, '\0');
    std::memcpy(las.data() + offset, &value, sizeof value);
  };
  las.replace(0, 4, "LASF");
  put(24, std::uint8_t{1});
  put(25, std::uint8_t{2});
  put(94, std::uint16_t{227});
  std::size_t data = 227;
  if (!keys.empty()) {
    const std::size_t bytes = 8 + 8 * keys.size();
    put(100, std::uint32_t{1});
    las.resize(227 + 54 + bytes, '\0');
    las.replace(229, 15, "LASF_Projection");
    put(245, std::uint16_t{34735});
    put(247, static_cast<std::uint16_t>(bytes));
    const std::uint16_t head[4] = {1, 1, 0, static_cast<std::uint16_t>(keys.size())};
    for (std::size_t k = 0; k < 4; ++k) put(281 + 2 * k, head[k]);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) put(289 + 8 * i + 2 * k, keys[i][k]);
    }
    data = las.size();
  }
  put(96, static_cast<std::uint32_t>(data));
  put(105, std::uint16_t{20});
  put(107, std::uint32_t{5});
  for (std::size_t k = 0; k < 3; ++k) put(131 + 8 * k, 0.01);
  const std::int32_t points[5][4] = {
      {50, 50, 100, 2}, {150, 50, 200, 2}, {50, 150, 300, 2}, {150, 150, 400, 2}, {50, 50, 900, 5}};
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t k = 0; k < 3; ++k) put(data + 20 * i + 4 * k, points[i][k]);
    put(data + 20 * i + 12, std::uint32_t{0});
    put(data + 20 * i + 15, static_cast<std::uint8_t>(points[i][3]));
    put(data + 20 * i + 16, std::uint32_t{0});
  }
  return las;
}

TEST_F(CloudGround, OnlyGroundPointsOfClassifiedLidarCount) {
  write_text_file(folder_ / "slope.las", five_point_las());
  const Terrain terrain = read_terrain({.surface = {folder_ / "slope.las"}, .resolution = 1.0});
  ASSERT_EQ(terrain.surface.vertices.size(), 4u);
  EXPECT_NEAR(bounds(terrain.surface).low.z(), 1.0, 1e-12);
  EXPECT_NEAR(bounds(terrain.surface).high.z(), 4.0, 1e-12);
  EXPECT_TRUE(contains(terrain.report.notes.front(), "1 points not classed as ground"));
}

// Keys of GeoTIFF: 1024 kind of system (1 projected, 2 geographic), 3072 and 2048 their codes.
TEST_F(CloudGround, MapSystemsOfLidarAreKeptAndDegreesFeetAndMixturesRefused) {
  const auto write = [&](const std::string& name, std::uint16_t kind, std::uint16_t code) {
    const std::uint16_t key = kind == 1 ? 3072 : 2048;
    write_text_file(folder_ / name, five_point_las({{1024, 0, 1, kind}, {key, 0, 1, code}}));
    return folder_ / name;
  };
  const auto utm = write("utm.las", 1, 32632), other = write("other.las", 1, 2154);
  const auto feet = write("feet.las", 1, 2225), degrees = write("degrees.las", 2, 4326);
  EXPECT_EQ(read_terrain({.surface = {utm}, .resolution = 1.0}).frame.crs, "EPSG:32632");
  const auto refused = [&](const std::vector<std::filesystem::path>& files) {
    return refusal(TerrainOptions{.surface = files, .resolution = 1.0});
  };
  EXPECT_TRUE(
      contains(refused({feet}), "feet.las: its map unit is the US survey foot (0.3048006 m)"));
  EXPECT_TRUE(contains(refused({degrees}), "degrees.las: coordinates are degrees"));
  EXPECT_TRUE(contains(
      refused({utm, other}),
      "other.las: is in RGF93 v1 / Lambert-93 (EPSG:2154), the clouds before it in WGS 84 / "
      "UTM zone 32N (EPSG:32632)"));
}

/// A plane of 20 x 20 points 1 m apart on a map, three of ten under trees of 8 m.
struct WoodedPlane {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> classes;

  explicit WoodedPlane(std::uint8_t ground, std::uint8_t tree) {
    for (int k = 0; k < 400; ++k) {
      const bool wooded = k % 10 < 3;
      const double x = k % 20, y = k / 20;
      points.emplace_back(500000 + x, 4400000 + y, 100 + x / 2 + y / 4 + (wooded ? 8 : 0));
      classes.push_back(wooded ? tree : ground);
    }
  }
};

TEST_F(CloudGround, ClassifiedLidarWithoutGroundSaysSoAndLeavesOutWhatStandsOnIt) {
  for (const auto& [ground, tree] :
       {std::pair(0, 5), {1, 5}, {1, 3}, {1, 4}, {1, 6}, {1, 14}, {8, 5}}) {
    const WoodedPlane plane(static_cast<std::uint8_t>(ground), static_cast<std::uint8_t>(tree));
    write_text_file(folder_ / "wood.las", declared_las({}, plane.points, plane.classes));
    const Terrain terrain = read_terrain({.surface = {folder_ / "wood.las"}, .resolution = 2.0});
    for (const Vec3& v : terrain.surface.vertices) {
      const Vec3 p = terrain.frame.to_map(v);
      EXPECT_NEAR(p.z(), 100 + (p.x() - 500000) / 2 + (p.y() - 4400000) / 4, 0.8);
    }
    const std::string note = terrain.report.notes.front();
    EXPECT_TRUE(contains(note, "wood.las: its points have the classes " +
                                   std::to_string(std::min(ground, tree)) + ", "));
    EXPECT_TRUE(contains(note,
                         "none is ground (2); 120 points of vegetation, buildings, wires and "
                         "bridges were left out and all other points were used as ground"));
  }
}

TEST_F(CloudGround, ClassesThatSayNothingOfTheGroundAreNoClasses) {
  for (const auto& [ground, tree] : {std::pair(0, 0), {1, 1}, {0, 1}}) {
    const WoodedPlane plane(static_cast<std::uint8_t>(ground), static_cast<std::uint8_t>(tree));
    write_text_file(folder_ / "wood.las", declared_las({}, plane.points, plane.classes));
    const Terrain terrain = read_terrain({.surface = {folder_ / "wood.las"}, .resolution = 2.0});
    EXPECT_TRUE(contains(terrain.report.notes.front(), "400 points, mean heights"));
  }
  const WoodedPlane trees(5, 5);
  write_text_file(folder_ / "wood.las", declared_las({}, trees.points, trees.classes));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "wood.las"}}),
                       "have the classes 5, and none is ground (2); all are vegetation, buildings, "
                       "wires or bridges: classify the ground first"));
}

TEST_F(CloudGround, LidarInFeetDegreesOrMercatorIsRefused) {
  const WoodedPlane plane(2, 2);
  const auto refused_with = [&](const std::vector<LasKey>& keys) {
    write_text_file(folder_ / "a.las", declared_las({.keys = keys}, plane.points));
    return refusal(TerrainOptions{.surface = {folder_ / "a.las"}, .resolution = 2.0});
  };
  EXPECT_EQ(refused_with({{1024, 1}, {3072, 26913}}), "");
  EXPECT_EQ(refused_with({{1024, 1}, {2048, 4269}, {3072, 32767}, {3076, 9001}}), "");
  EXPECT_TRUE(contains(refused_with({{1024, 1}, {3072, 26913}, {4099, 9003}}),
                       "a.las: its heights are in units of the US survey foot"));
  EXPECT_TRUE(contains(refused_with({{1024, 1}, {3072, 26913}, {4096, 6360}}),
                       "a.las: its heights are in units of the US survey foot"));
  EXPECT_TRUE(contains(refused_with({{1024, 1}, {3072, 32767}, {3076, 9002}}),
                       "a.las: its map unit is the foot (0.3048 m)"));
  EXPECT_TRUE(contains(refused_with({{1024, 2}, {2048, 4326}}), "coordinates are degrees"));
  EXPECT_TRUE(contains(refused_with({{1024, 3}, {2048, 4978}}), "so that z is not up"));
  // 4400 km on the sphere of Mercator is latitude 36.7: the scale is 1 / cos = 1.246.
  EXPECT_TRUE(contains(refused_with({{1024, 1}, {3072, 3857}}),
                       "lengths on its map (WGS 84 / Pseudo-Mercator (EPSG:3857)) are 1.2"));
}

TEST_F(CloudGround, HeightsThatStandForNoneAreRefused) {
  for (const char* fill : {"-9999", "-999", "-99", "9999", "0", "1e20", "-32768"}) {
    std::ostringstream text;
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 20; ++i) {
        text << i + 0.5 << ' ' << j + 0.5 << ' ';
        if (i < 3) {
          text << fill << '\n';
        } else {
          text << 500 + 0.5 * i << '\n';
        }
      }
    }
    const std::string message = refused(text.str());
    EXPECT_TRUE(contains(message, "stands for no data, leave out the points with that height"))
        << fill;
  }
}

// Cells of several points hide single fill values in their means.
TEST_F(CloudGround, FillValuesBetweenOtherPointsOfACellAreRefused) {
  for (const char* fill : {"-9999", "-999", "9999", "0"}) {
    std::ostringstream text;
    for (int i = 0; i < 400; ++i) {
      text << i % 20 << ' ' << i / 20 << ' ';
      if (i % 10 == 0) {
        text << fill << '\n';
      } else {
        text << 500 + 0.5 * (i % 20) << '\n';
      }
    }
    const std::string message = refused(text.str());
    EXPECT_TRUE(contains(message, "40 points have the height " + std::string(fill) + " m")) << fill;
  }
}

TEST_F(CloudGround, LinesThatAreNoPointsAreRefusedWithTheirNumber) {
  EXPECT_TRUE(contains(refused("0 0 0\n1 2\n"), "cloud.xyz: line 2: fewer than three numbers"));
  EXPECT_TRUE(contains(refused("0 0 0\n1 2 wet\n"), "cloud.xyz: line 2: \"wet\""));
  EXPECT_TRUE(contains(refused(""), "holds no points"));
  EXPECT_TRUE(contains(refused("x y z\n"), "holds no points"));
  EXPECT_TRUE(contains(refused("0 0 0\n0.5 0 0\n"), "a surface needs at least four"));
  EXPECT_TRUE(contains(refused("0 0 0\n1e9 1e9 0\n"), "too many"));
}

}  // namespace
}  // namespace clast
