// The map of a terrain with release points and barriers, of a campaign and of a comparison.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <regex>

#include "core/files/text_file.hpp"
#include "report/maps/svg_map.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/markup.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

std::string bytes_of_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) break;
    bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFFF;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

struct Close {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// The relief in a map, as GDAL reads it.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> indices;
  std::vector<std::array<int, 3>> colours;

  Pixels(const ScratchFolder& folder, const std::string& svg) {
    const std::string link = "data:image/png;base64,";
    write_text_file(folder / "relief.png",
                    bytes_of_base64(svg.substr(svg.find(link) + link.size())));
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, Close> dataset(
        GDALDataset::Open((folder / "relief.png").c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
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
  std::uint8_t index(double column, double row) const {
    return indices.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column));
  }
  std::array<int, 3> at(double column, double row) const { return colours.at(index(column, row)); }
};

/// Groups of the first match, as numbers.
std::vector<double> numbers_of(const std::string& svg, const std::string& pattern) {
  std::smatch match;
  if (!std::regex_search(svg, match, std::regex(pattern))) return {};
  std::vector<double> numbers;
  for (std::size_t i = 1; i < match.size(); ++i) numbers.push_back(std::stod(match[i]));
  return numbers;
}

/// Words of the legend, which follows the north arrow.
std::vector<std::string> legend_of(const std::string& svg) {
  std::vector<std::string> words;
  const std::string legend = svg.substr(svg.find(">N</text>") + 1);
  const std::regex text("<text[^>]*>([^<]*)</text>");
  for (std::sregex_iterator it(legend.begin(), legend.end(), text), end; it != end; ++it) {
    words.push_back((*it)[1]);
  }
  return words;
}

// 20 x 10 m with a margin of 7 % of the longer side all round: 22.8 x 12.8 m, 790 px wide, with its
// upper left corner at (88, 12).
constexpr double kScale = 790.0 / 22.8;  // px/m
double map_x(double x) { return 88.0 + kScale * (x + 1.4); }
double map_y(double y) { return 12.0 + kScale * (11.4 - y); }
constexpr double kRounding = 0.051;  // px, of coordinates in the file

class SvgMap : public testing::Test {
 protected:
  /// Level, green in the west and red in the east; with `rise`, of a slope to the east.
  Terrain ground(double rise = 0.0) {
    TriangleMesh west = squares(10, 1.0, [&](double x, double) { return 500.0 + rise * x; });
    TriangleMesh east = squares(10, 1.0, [&](double x, double) { return 500.0 + rise * (x + 10); });
    for (Vec3& v : west.vertices) v += Vec3(652000, 5203000, 0);
    for (Vec3& v : east.vertices) v += Vec3(652010, 5203000, 0);
    write_mesh(folder_ / "west.ply", west);
    write_mesh(folder_ / "east.ply", east);
    return read_terrain(
        {.surface = {folder_ / "west.ply", folder_ / "east.ply"}, .zones = {"green", "red"}});
  }
  const ScratchFolder folder_;
  const std::vector<Vec2> release_ = {Vec2(652003, 5203008)};
  const std::vector<std::vector<Vec2>> line_ = {{Vec2(652015, 5203001), Vec2(652015, 5203009)}};
};

TEST_F(SvgMap, ShowsZonesReleasePointsAndBarriersWhereTheyAre) {
  const Terrain terrain = ground();
  const std::string svg = draw_svg_map(make_site_map(terrain, release_, line_));
  EXPECT_EQ(unbalanced(svg), "");
  const std::vector<double> cross =
      numbers_of(svg, "stroke=\"#111\"[^>]*d=\"M([0-9.]+) ([0-9.]+)m[^>]*><title>release point 0<");
  ASSERT_EQ(cross.size(), 2u);
  EXPECT_NEAR(cross[0], map_x(3.0), kRounding);
  EXPECT_NEAR(cross[1], map_y(8.0), kRounding);
  const std::vector<double> line = numbers_of(
      svg, "stroke=\"#111\" stroke-width=\"2.2\" d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\"");
  ASSERT_EQ(line.size(), 4u);
  EXPECT_NEAR(line[0], map_x(15.0), kRounding);
  EXPECT_NEAR(line[1], map_y(1.0), kRounding);
  EXPECT_NEAR(line[2], map_x(15.0), kRounding);
  EXPECT_NEAR(line[3], map_y(9.0), kRounding);
  EXPECT_FALSE(contains(svg, "counted through")) << "nothing is counted at a line of a terrain";

  const Pixels relief(folder_, svg);
  ASSERT_EQ(relief.width, 790);
  ASSERT_EQ(relief.height, 444);
  const auto column = [](double x) { return map_x(x) - 88.0; };
  const auto row = [](double y) { return map_y(y) - 12.0; };
  // Level ground has its zone's own hue.
  const std::array<int, 3> west = relief.at(column(6.0), row(5.0));
  const std::array<int, 3> east = relief.at(column(12.0), row(5.0));
  EXPECT_GT(west[1], west[0]);
  EXPECT_GT(east[0], east[1]);
  EXPECT_EQ(relief.index(column(-0.3), row(5.0)), 0) << "transparent off the ground";
  EXPECT_EQ(relief.index(column(5.0), row(10.3)), 0);
  EXPECT_NE(relief.index(column(0.2), row(9.8)), 0);
}

TEST_F(SvgMap, HoldsAllMarks) {
  const Terrain terrain = ground();
  const std::vector<Vec2> far = {Vec2(652035, 5203008), Vec2(651995, 5202985)};
  const std::string svg = draw_svg_map(make_site_map(terrain, far, {}));
  const std::vector<double> size = numbers_of(svg, "<svg width=\"([0-9]+)\" height=\"([0-9]+)\"");
  const std::vector<double> frame =
      numbers_of(svg, "width=\"([0-9.]+)\" height=\"([0-9.]+)\" fill=\"none\" stroke=\"#33404d\"");
  ASSERT_EQ(size.size(), 2u);
  ASSERT_EQ(frame.size(), 2u);
  EXPECT_LE(88.0 + frame[0], size[0]);
  EXPECT_LE(12.0 + frame[1], size[1]);
  for (const char* number : {"0", "1"}) {
    const std::vector<double> cross = numbers_of(
        svg, "d=\"M([0-9.]+) ([0-9.]+)m[^>]*><title>release point " + std::string(number) + "<");
    ASSERT_EQ(cross.size(), 2u);
    EXPECT_GT(cross[0], 88.0 + 6.0);
    EXPECT_LT(cross[0], 88.0 + frame[0] - 6.0);
    EXPECT_GT(cross[1], 12.0 + 6.0);
    EXPECT_LT(cross[1], 12.0 + frame[1] - 6.0);
  }
}

TEST_F(SvgMap, HasAScaleBarOfItsLengthAndAnArrowToTheNorth) {
  for (const double larger : {1.0, 3.0, 700.0}) {
    Terrain terrain = ground();
    for (Vec3& v : terrain.surface.vertices) v *= larger;
    const std::string svg = draw_svg_map(make_site_map(terrain, {}, {}));
    const std::vector<double> bar =
        numbers_of(svg,
                   "width=\"([0-9.]+)\" height=\"5.0\" fill=\"#111\" stroke=\"#111\"/><rect [^>]*"
                   "width=\"([0-9.]+)\" height=\"5.0\" fill=\"#fff\" stroke=\"#111\"/><text "
                   "[^>]*>([0-9.]+) m<");
    ASSERT_EQ(bar.size(), 3u) << larger;
    EXPECT_NEAR(bar[0] + bar[1], bar[2] * kScale / larger, 2.0 * kRounding) << larger;
    EXPECT_GT(bar[0] + bar[1], 80.0);
  }
  const Terrain terrain = ground();
  const std::string svg = draw_svg_map(make_site_map(terrain, {}, {}));
  // A tip up, over an N.
  const std::vector<double> arrow = numbers_of(
      svg,
      "d=\"M([0-9.]+) ([0-9.]+)l7 19-7-5-7 5z\"/><text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>N<");
  ASSERT_EQ(arrow.size(), 4u);
  EXPECT_EQ(arrow[0], arrow[2]);
  EXPECT_GT(arrow[3], arrow[1] + 19.0);
}

TEST_F(SvgMap, HasALegendOfMarksContoursAndZones) {
  using Words = std::vector<std::string>;
  const Terrain level = ground(), slope = ground(0.5);
  EXPECT_EQ(legend_of(draw_svg_map(make_site_map(level, release_, line_))),
            (Words{"Site", "release point", "barrier", "Ground zones", "green", "red"}));
  EXPECT_EQ(
      legend_of(draw_svg_map(make_site_map(slope, release_, {}))),
      (Words{"Site", "release point", "contours every 1.0 m", "Ground zones", "green", "red"}));
  const std::string bare = draw_svg_map(make_site_map(level, {}, {}));
  EXPECT_EQ(legend_of(bare), (Words{"Ground zones", "green", "red"}));
  EXPECT_TRUE(contains(bare, "fill=\"#d0e4c8\"")) << "the swatch of \"green\"";
  EXPECT_TRUE(contains(bare, "fill=\"#f5ccc6\"")) << "the swatch of \"red\"";
}

// The floor of a quarry at a round height, high on the map: its heights are round but for rounding.
TEST_F(SvgMap, LevelGroundHasNoContoursAndASlopeHas) {
  const auto contour_pixels = [&](const Terrain& terrain) {
    const Pixels relief(folder_, draw_svg_map(make_site_map(terrain, {}, {})));
    EXPECT_EQ(relief.colours.at(1), (std::array<int, 3>{122, 98, 69}));
    return std::count(relief.indices.begin(), relief.indices.end(), 1);
  };
  Terrain terrain = ground();
  const double turn = std::numbers::pi / 7.0;  // sides across the pixels
  for (Vec3& v : terrain.surface.vertices) {
    v = Vec3(std::cos(turn) * v.x() - std::sin(turn) * v.y(),
             std::sin(turn) * v.x() + std::cos(turn) * v.y(), 10.0);
  }
  EXPECT_EQ(contour_pixels(terrain), 0);
  // 501, 502, ... 509 m from south to north, a pixel wide each; 500 and 510 lie on the border.
  const std::ptrdiff_t on_slope = contour_pixels(ground(0.5));
  EXPECT_NEAR(static_cast<double>(on_slope), 9.0 * 10.0 * kScale, 0.15 * 9.0 * 10.0 * kScale);
}

// Names in any language and of any length.
TEST_F(SvgMap, LegendsFitWhateverTheNames) {
  write_mesh(folder_ / "a.ply", squares(10, 1.0, [](double x, double) { return 500.0 + x; }));
  for (const std::string& name :
       {std::string("Ger\xC3\xB6ll"), std::string(300, 'x'), std::string("\xE5\xB2\xA9"),
        std::string("rock (wet), 2: <a>/\"b\"&")}) {
    const Terrain terrain = read_terrain({.surface = {folder_ / "a.ply"}, .zones = {name}});
    const std::string svg = draw_svg_map(make_site_map(terrain, {}, {}));
    EXPECT_EQ(unbalanced(svg), "") << name;
    EXPECT_FALSE(contains(svg, std::string(30, 'x')));
  }
  Terrain many = read_terrain({.surface = {folder_ / "a.ply"}});
  many.zone_names.assign(60, "zone");
  const std::string svg = draw_svg_map(make_site_map(many, {}, {}));
  EXPECT_EQ(legend_of(svg).size(), 63u);
  const std::vector<double> size = numbers_of(svg, "<svg width=\"([0-9]+)\" height=\"([0-9]+)\"");
  EXPECT_GT(size.at(1), 60.0 * 19.0);
}

TEST_F(SvgMap, AMarkInAnotherPlaceIsRefused) {
  const Terrain terrain = ground();
  const std::vector<Vec2> release = {Vec2(3, 8)};
  EXPECT_EQ(refusal<Error>([&] { make_site_map(terrain, release, {}); }),
            "the release point at x 3.000, y 8.000, z 0.000 is far off the ground, whose lowest x "
            "and y are at "
            "x 652000.000, y 5203000.000, z 0.000; convert both to one map system");
  EXPECT_TRUE(
      contains(refusal<Error>([&] {
                 make_site_map(terrain, {}, {line_[0], {line_[0][0], Vec2(652041, 5203001)}});
               }),
               "the barrier at x 652041.000, y 5203001.000, z 0.000 is far off the ground"));
}

TEST(SvgMapOfCampaign, ShowsReleasePointsOnceAndTheWayThatCounts) {
  CampaignResults header = hand_made_results();
  header.runs.clear();
  header.crossings.clear();
  header.release_points = {Vec3(0, 0, 2), Vec3(5, 3, 2), Vec3(0, 0, 3)};
  header.barriers[0].counted = CountedDirection::kForward;
  header.barriers.push_back({"ring", {Vec2(30, 0), Vec2(40, 0), Vec2(40, 9), Vec2(30, 0)}});
  const SiteMap site = make_site_map(header);
  ASSERT_EQ(site.release_positions.size(), 2u);
  EXPECT_EQ(site.release_positions[1].point, 1u);
  EXPECT_EQ(site.release_positions[1].position, Vec2(kMapOrigin.head<2>() + Vec2(5, 3)));
  EXPECT_TRUE(site.release_outlines.empty());
  // Heights of the ground, 30 m on 70 m.
  EXPECT_EQ(site.contour_interval(), 5.0);
  const std::string svg = draw_svg_map(site);
  EXPECT_EQ(unbalanced(svg), "");
  EXPECT_EQ(count_of(svg, "<title>release point"), 2u);
  EXPECT_EQ(count_of(svg, "<title>counted through B&lt;1&gt;</title>"), 1u);
  EXPECT_EQ(count_of(svg, "<title>counted through B2</title>"), 2u) << "either way";
  EXPECT_EQ(count_of(svg, "<title>counted through ring</title>"), 1u) << "inwards";
  EXPECT_EQ(legend_of(svg)[2], "barrier, crossings counted");
}

TEST(SvgMapOfComparison, HoldsTheRunsAndOutlinesOfMasses) {
  CampaignResults results = hand_made_results();
  const SiteMap apart = make_site_map(compared(results));
  ASSERT_EQ(apart.release_positions.size(), 1u);
  EXPECT_TRUE(apart.release_outlines.empty());
  // Stops at x 10 to 40 and y -10 to 20, barriers at y -20 and 20.
  EXPECT_LT(apart.window.low.x(), kMapOrigin.x());
  EXPECT_GT(apart.window.high.x(), kMapOrigin.x() + 40.0);
  EXPECT_LT(apart.window.high.x(), kMapOrigin.x() + 60.0) << "not the whole ground";

  results.persistent_blocks = {3, {0.01, 0.5, 0.3}, true};
  for (std::uint32_t run = 0; run < 6; ++run) {
    results.persistent_block_records.push_back({.run = run});
    results.runs[run].start.position = Vec3(run % 3, run % 2, 2.0);
  }
  const Comparison comparison = compared(std::move(results));
  const SiteMap mass = make_site_map(comparison);
  EXPECT_TRUE(mass.release_positions.empty());
  ASSERT_EQ(mass.release_outlines.size(), 1u);
  EXPECT_EQ(mass.release_outlines[0].name, "release of 3 blocks") << "in each of two realisations";
  EXPECT_EQ(mass.release_outlines[0].corners.size(), 4u);
  const std::string svg = draw_svg_map(mass);
  EXPECT_EQ(unbalanced(svg), "");
  EXPECT_EQ(count_of(svg, "stroke-dasharray=\"6 4\""), 2u) << "on the map and in the legend";
  EXPECT_EQ(legend_of(svg)[1], "release of 3 blocks");
}

}  // namespace
}  // namespace clast
