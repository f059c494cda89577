// The picture of a ground with its release points and barriers.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <set>

#include "core/files/text_file.hpp"
#include "terrain/hillshade.hpp"
#include "terrain/relief.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

struct Close {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// A PNG as GDAL reads it.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> indices;
  std::vector<std::array<int, 3>> colours;

  explicit Pixels(const std::filesystem::path& path) {
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, Close> dataset(
        GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (!dataset) return;
    GDALRasterBand* band = dataset->GetRasterBand(1);
    width = band->GetXSize();
    height = band->GetYSize();
    indices.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    EXPECT_EQ(band->RasterIO(GF_Read, 0, 0, width, height, indices.data(), width, height, GDT_Byte,
                             0, 0, nullptr),
              CE_None);
    for (int i = 0; i < band->GetColorTable()->GetColorEntryCount(); ++i) {
      const GDALColorEntry* entry = band->GetColorTable()->GetColorEntry(i);
      colours.push_back({entry->c1, entry->c2, entry->c3});
    }
  }
  std::array<int, 3> at(int column, int row) const {
    return colours.at(indices.at(static_cast<std::size_t>(row * width + column)));
  }
};

bool is_black(const std::array<int, 3>& c) { return c[0] < 60 && c[1] < 60 && c[2] < 60; }

class Hillshade : public testing::Test {
 protected:
  Terrain ground() {
    TriangleMesh west = squares(10, 1.0, [](double, double) { return 500.0; }), east = west;
    for (Vec3& v : west.vertices) v += Vec3(652000, 5203000, 0);
    for (Vec3& v : east.vertices) v += Vec3(652010, 5203000, 0);
    write_mesh(folder_ / "west.ply", west);
    write_mesh(folder_ / "east.ply", east);
    return read_terrain(
        {.surface = {folder_ / "west.ply", folder_ / "east.ply"}, .zones = {"green", "red"}});
  }
  const ScratchFolder folder_;
};

// 20 x 10 m with a margin of 2 % of the longer side all round: 20.8 x 10.8 m on 1,040 pixels, that
// is 50 per metre; (652000 + x, 5203000 + y) is in column 50 (x + 0.4), row 50 (10.4 - y).
TEST_F(Hillshade, ShowsZonesReleasePointsAndBarriersWhereTheyAre) {
  const MapMarks marks{.releases = {Vec2(652003, 5203008)},
                       .barriers = {{Vec2(652015, 5203001), Vec2(652015, 5203009)}}};
  write_hillshade(folder_ / "map.png", ground(), marks, {}, 1040);
  const Pixels picture(folder_ / "map.png");
  ASSERT_EQ(picture.width, 1040);
  ASSERT_EQ(picture.height, 540);
  const auto at = [&](double x, double y) {
    return picture.at(static_cast<int>(50.0 * (x + 0.4)), static_cast<int>(50.0 * (10.4 - y)));
  };
  EXPECT_TRUE(is_black(at(3.0, 8.0)));
  EXPECT_FALSE(is_black(at(8.0, 3.0))) << "mirrored";
  EXPECT_FALSE(is_black(at(3.0, 2.0))) << "upside down";
  EXPECT_TRUE(is_black(at(15.0, 5.0)));
  EXPECT_TRUE(is_black(at(15.0, 1.1)));
  EXPECT_FALSE(is_black(at(15.0, 0.8)));
  EXPECT_FALSE(is_black(at(15.5, 5.0)));
  // Level ground has its zone's own hue.
  const std::array<int, 3> west = at(6.0, 5.0), east = at(12.0, 5.0);
  EXPECT_GT(west[1], west[0]);
  EXPECT_GT(east[0], east[1]);
  // Off the ground: transparent.
  EXPECT_EQ(picture.indices.at(5), 0);
}

// Of 20.8 m the largest round length within a fifth is 2 m, 100 pixels: a black and a white half.
TEST_F(Hillshade, HasAScaleBarAndAnArrowToTheNorth) {
  write_hillshade(folder_ / "map.png", ground(), {}, {}, 1040);
  const Pixels picture(folder_ / "map.png");
  const auto blacks = [&](int left, int right, int row) {
    std::vector<int> columns;
    for (int column = left; column < right; ++column) {
      if (is_black(picture.at(column, row))) columns.push_back(column);
    }
    return columns;
  };
  // The bar is the lowest row with ink in the lower left quarter.
  std::size_t longest = 0;
  for (int row = picture.height / 2; row < picture.height; ++row) {
    const std::vector<int> ink = blacks(0, picture.width / 2, row);
    if (ink.empty()) continue;
    longest = std::max(longest, static_cast<std::size_t>(ink.back() - ink.front() + 1));
  }
  EXPECT_NEAR(static_cast<double>(longest), 100.0, 2.0);
  // The arrow is a triangle with its tip up, over an N.
  std::vector<std::size_t> widths;
  for (int row = 0; row < picture.height / 2; ++row) {
    const std::vector<int> ink = blacks(picture.width / 2, picture.width, row);
    if (!ink.empty()) widths.push_back(ink.size());
  }
  ASSERT_GT(widths.size(), 25u);
  EXPECT_LE(widths.front(), 2u);
  EXPECT_TRUE(std::is_sorted(widths.begin(), widths.begin() + 15));
  EXPECT_GE(widths[14], 12u);
}

// Two zones, a cross and a line: four rows of ink on a pale panel, with the tints of the zones.
TEST_F(Hillshade, HasALegendOfZonesAndMarks) {
  const MapMarks marks{.releases = {Vec2(652003, 5203008)},
                       .barriers = {{Vec2(652008, 5203001), Vec2(652008, 5203009)}}};
  const auto rows_of_text = [&](const MapMarks& drawn) {
    write_hillshade(folder_ / "map.png", ground(), drawn, {}, 1040);
    const Pixels picture(folder_ / "map.png");
    std::size_t rows = 0;
    bool before = false;
    for (int row = picture.height / 2; row < picture.height; ++row) {
      bool ink = false;
      for (int column = picture.width - 120; column < picture.width - 20; ++column) {
        ink = ink || is_black(picture.at(column, row));
      }
      rows += ink && !before;
      before = ink;
    }
    return rows;
  };
  EXPECT_EQ(rows_of_text(marks), 4u);
  EXPECT_EQ(rows_of_text({}), 2u) << "level ground has no contours";
  // The swatches have the hues of the zones.
  const Pixels picture(folder_ / "map.png");
  std::set<std::array<int, 3>> colours;
  for (int row = picture.height / 2; row < picture.height - 8; ++row) {
    for (int column = picture.width - 260; column < picture.width - 8; ++column) {
      colours.insert(picture.at(column, row));
    }
  }
  const auto has = [&](const Rgb& tint) {
    return std::any_of(colours.begin(), colours.end(), [&](const std::array<int, 3>& colour) {
      int off = 0;
      for (int i = 0; i < 3; ++i) off += std::abs(colour[i] - tint[i]);
      return off < 40;
    });
  };
  EXPECT_TRUE(has(zone_tint("green", 0)));
  EXPECT_TRUE(has(zone_tint("red", 1)));
}

// Names in any language and of any length: the panel stays inside its quarter.
TEST_F(Hillshade, LegendsFitWhateverTheNames) {
  TriangleMesh mesh = squares(10, 1.0, [](double x, double) { return 500.0 + x; });
  write_mesh(folder_ / "a.ply", mesh);
  for (const std::string& name : {std::string("Ger\xC3\xB6ll"), std::string(300, 'x'),
                                  std::string("\xE5\xB2\xA9"), std::string("rock (wet), 2: a/b")}) {
    for (const std::uint32_t pixels : {20u, 200u, 900u}) {
      write_hillshade(folder_ / "map.png",
                      read_terrain({.surface = {folder_ / "a.ply"}, .zones = {name}}), {}, {},
                      pixels);
      EXPECT_EQ(Pixels(folder_ / "map.png").width, static_cast<int>(pixels)) << name;
    }
  }
}

TEST_F(Hillshade, AMarkInAnotherPlaceIsRefused) {
  const MapMarks marks{.releases = {Vec2(3, 8)}, .barriers = {}};
  const std::string message =
      refusal<Error>([&] { write_hillshade(folder_ / "map.png", ground(), marks); });
  EXPECT_EQ(message,
            "the release point at x 3.000, y 8.000, z 0.000 is far off the ground, which begins at "
            "x 652000.000, y 5203000.000, z 0.000; bring both into one map system");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "map.png"));
}

TEST_F(Hillshade, BarriersComeFromLineFiles) {
  write_text_file(folder_ / "nets.geojson",
                  R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
                  R"("geometry":{"type":"MultiLineString","coordinates":[[[652001,5203001],)"
                  R"([652004,5203002],[652007,5203001]],[[652011,5203001],[652012,5203002]]]}}]})");
  const auto lines = read_barrier_lines(folder_ / "nets.geojson", ground());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].size(), 3u);
  EXPECT_EQ(lines[0][1], Vec2(652004, 5203002));
}

}  // namespace
}  // namespace clast
