#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>

#include "core/error.hpp"
#include "core/html_page.hpp"
#include "core/png.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "study/report/gis_layers.hpp"
#include "study/report/html_report.hpp"
#include "study/report/svg_map.hpp"
#include "study/report/ticks.hpp"
#include "terrain/relief.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

TEST(HtmlReport, TagsAreBalanced) {
  EXPECT_EQ(unbalanced(html_report(compared(hand_made_results()))), "");
  EXPECT_NE(unbalanced("<p><b>x</p></b>"), "");
  EXPECT_NE(unbalanced("<p>"), "");
}

TEST(HtmlReport, NamesEveryBlockWithItsCharactersEscaped) {
  const std::string html = html_report(compared(hand_made_results()));
  EXPECT_TRUE(contains(html, "round&lt;1&gt;"));
  EXPECT_TRUE(contains(html, "long, &quot;2&quot;"));
  EXPECT_TRUE(contains(html, "B&lt;1&gt;"));
  EXPECT_FALSE(contains(html, "round<1>"));
  EXPECT_FALSE(contains(html, "B<1>"));
  EXPECT_TRUE(contains(html, "# a &lt; b &amp; c"));
}

TEST(HtmlReport, SaysWhatWasRun) {
  const std::string html = html_report(compared(hand_made_results()));
  for (const std::string& part : {std::string(64, 'a'), std::string(64, 'b'), std::string(64, 'c'),
                                  std::string("hand-made.h5"), std::string("clast 0.1.0")}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
}

TEST(HtmlReport, RefersToNothingOutsideItself) {
  expect_self_contained(html_report(compared(hand_made_results())));
}

TEST(HtmlReport, ShowsWarningsAndLostRunsWithTheirReason) {
  CampaignResults results = hand_made_results();
  results.runs[2].result.stop_reason = StopReason::kError;
  results.runs[2].result.message = "turned to <nan> in step 7";
  results.runs[2].result.final_state.position = Vec3::Constant(NAN);
  const std::string html = html_report(compared(std::move(results)));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "mass differs between classes"));
  EXPECT_TRUE(contains(html, "1 of 6 runs ended with an error"));
  EXPECT_TRUE(contains(html, "turned to &lt;nan&gt; in step 7"));
  EXPECT_FALSE(contains(html, "=\"nan\""));
}

TEST(HtmlReport, StandsRunsThatAllFailed) {
  CampaignResults results = hand_made_results();
  results.crossings.clear();
  for (RunRecord& run : results.runs) {
    run.result = ReleaseResult();
    run.result.final_state.position = Vec3::Constant(NAN);
  }
  EXPECT_EQ(unbalanced(html_report(compared(std::move(results)))), "");
}

TEST(HtmlReport, StandsOneRunWithoutBarriersOrTerrain) {
  CampaignResults results = hand_made_results();
  results.runs.resize(1);
  results.crossings.clear();
  results.barriers.clear();
  results.terrain = Terrain();
  results.terrain.frame = results.frame;
  EXPECT_EQ(unbalanced(html_report(compared(std::move(results)))), "");
}

TEST(SvgMap, MarksEveryStopUntilThereAreTooMany) {
  CampaignResults few = hand_made_results();
  const std::string map = svg_map(compared(few));
  EXPECT_TRUE(contains(map, "run 4, block long, &quot;2&quot;, point 0, orientation 4"));
  EXPECT_TRUE(contains(map, "900010"));  // axis in map coordinates

  CampaignResults many = hand_made_results();
  Random random(1);
  while (many.runs.size() <= kMostSingleStops) {
    const auto run = static_cast<std::uint32_t>(many.runs.size());
    many.runs.push_back(
        hand_made_run(run, run % 2, random.uniform(5.0, 45.0), random.uniform(-15.0, 15.0)));
  }
  const std::string density = svg_map(compared(std::move(many)));
  EXPECT_FALSE(contains(density, "class=\"stop\""));
  EXPECT_TRUE(contains(density, " stops</title>"));
  EXPECT_LT(density.size(), 2u << 20);
}

TEST(Geopackage, ReopensWithItsLayersOnTheMap) {
  const ScratchFolder folder;
  CampaignResults results = hand_made_results();
  results.frame.crs = results.terrain.frame.crs = "EPSG:2154";
  write_geopackage(folder / "stops.gpkg", compared(std::move(results)));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);

  const Dataset dataset(
      GDALDataset::Open((folder / "stops.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  ASSERT_NE(dataset, nullptr);
  OGRLayer* stops = dataset->GetLayerByName("stops");
  OGRLayer* crossings = dataset->GetLayerByName("crossings");
  OGRLayer* barriers = dataset->GetLayerByName("barriers");
  ASSERT_NE(stops, nullptr);
  ASSERT_NE(crossings, nullptr);
  ASSERT_NE(barriers, nullptr);
  EXPECT_EQ(stops->GetFeatureCount(), 6);
  EXPECT_EQ(crossings->GetFeatureCount(), 7);
  EXPECT_EQ(barriers->GetFeatureCount(), 2);
  ASSERT_NE(stops->GetSpatialRef(), nullptr);
  EXPECT_STREQ(stops->GetSpatialRef()->GetAuthorityCode(nullptr), "2154");

  const OGRFeatureUniquePtr stop(stops->GetNextFeature());
  EXPECT_STREQ(stop->GetFieldAsString("block"), "round<1>");
  EXPECT_STREQ(stop->GetFieldAsString("shape"), "compact");
  EXPECT_EQ(stop->GetGeometryRef()->toPoint()->getX(), kMapOrigin.x() + 10.0);
  EXPECT_EQ(stop->GetGeometryRef()->toPoint()->getY(), kMapOrigin.y());
  EXPECT_EQ(stop->GetGeometryRef()->toPoint()->getZ(), kMapOrigin.z() - 5.0);
  const OGRFeatureUniquePtr barrier(barriers->GetNextFeature());
  EXPECT_NEAR(barrier->GetFieldAsDouble("probability"), 4.0 / 6.0, 1e-15);
  EXPECT_EQ(barrier->GetGeometryRef()->toLineString()->getY(1), kMapOrigin.y() + 20.0);
}

TEST(Geopackage, WithoutACrsCoordinatesAreNotDegrees) {
  const ScratchFolder folder;
  write_geopackage(folder / "stops.gpkg", compared(hand_made_results()));
  const Dataset dataset(
      GDALDataset::Open((folder / "stops.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  ASSERT_NE(dataset, nullptr);
  for (OGRLayer* layer : dataset->GetLayers()) {
    const OGRSpatialReference* system = layer->GetSpatialRef();
    EXPECT_FALSE(system && system->IsGeographic()) << layer->GetName();
  }
}

TEST(Geopackage, FolderAsTargetIsRefused) {
  const ScratchFolder folder;
  EXPECT_THROW(write_geopackage(folder.path(), compared(hand_made_results())), InputError);
}

TEST(Png, IsReadBackByGdal) {
  GDALAllRegister();
  const ScratchFolder folder;
  Random random(5);
  const std::uint32_t width = 311, height = 257;  // more than one stored block of 65535 bytes
  std::vector<std::uint8_t> pixels(width * height);
  for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(random.below(200));
  std::vector<Rgb> palette;
  for (int i = 0; i < 200; ++i) {
    palette.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 7});
  }
  write_text_file(folder / "a.png", palette_png(width, height, pixels, palette));
  const Dataset dataset(
      GDALDataset::Open((folder / "a.png").c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  ASSERT_NE(dataset, nullptr);
  std::vector<std::uint8_t> back(pixels.size());
  GDALRasterBand* band = dataset->GetRasterBand(1);
  ASSERT_EQ(
      band->RasterIO(GF_Read, 0, 0, width, height, back.data(), width, height, GDT_Byte, 0, 0),
      CE_None);
  EXPECT_EQ(back, pixels);
  EXPECT_EQ(band->GetColorTable()->GetColorEntry(100)->c2, 155);
}

TEST(Png, ColoursAreReadBackByGdal) {
  GDALAllRegister();
  const ScratchFolder folder;
  Random random(6);
  const int width = 131, height = 77;
  std::vector<Rgb> pixels(width * height);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool noisy = i / width % 2 == 0;  // rows for either filter
    for (std::uint8_t& part : pixels[i]) {
      part = static_cast<std::uint8_t>(noisy ? random.below(256) : i % width);
    }
  }
  write_text_file(folder / "a.png", rgb_png(width, height, pixels));
  const Dataset dataset(
      GDALDataset::Open((folder / "a.png").c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  ASSERT_NE(dataset, nullptr);
  ASSERT_EQ(dataset->GetRasterCount(), 3);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<std::uint8_t> back(pixels.size());
    ASSERT_EQ(dataset->GetRasterBand(channel + 1)
                  ->RasterIO(GF_Read, 0, 0, width, height, back.data(), width, height, GDT_Byte, 0,
                             0),
              CE_None);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      ASSERT_EQ(back[i], pixels[i][static_cast<std::size_t>(channel)]) << i;
    }
  }
}

TEST(HtmlPage, LinksKeepOddNames) {
  EXPECT_EQ(link_to("blocks/B 1 #2?.html"), "blocks/B%201%20%232%3F.html");
  EXPECT_EQ(link_to("\xC3\xA9"), "%C3%A9");
}

TEST(Base64, EncodesTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

TEST(Relief, SamplesThePlaneAtCellCentres) {
  const CampaignResults results = hand_made_results();
  const Window window{Vec2(-20.0, -25.0), Vec2(60.0, 15.0)};
  const Relief relief = sampled(results.terrain, window, 80);
  ASSERT_EQ(relief.columns, 80u);
  ASSERT_EQ(relief.rows, 40u);
  for (std::uint32_t row = 0; row < relief.rows; ++row) {
    for (std::uint32_t column = 0; column < relief.columns; ++column) {
      const double x = -19.5 + column, height = relief.height[row * 80 + column];
      if (x < -10.0) {
        EXPECT_TRUE(std::isnan(height));
      } else {
        EXPECT_NEAR(height, -0.5 * x, 1e-12);
        EXPECT_EQ(relief.zone[row * 80 + column], x < 20.0 ? 0 : 1);
      }
    }
  }
}

TEST(Relief, ShowsTheUpperOfTwoSurfaces) {
  Terrain terrain;
  for (const double z : {5.0, 1.0}) {
    for (const Vec2& corner : {Vec2(0, 0), Vec2(4, 0), Vec2(0, 4)}) {
      terrain.surface.vertices.push_back({corner.x(), corner.y(), z});
    }
  }
  terrain.surface.triangles = {{0, 1, 2}, {3, 4, 5}};
  terrain.zone = {1, 0};
  const Relief relief = sampled(terrain, {Vec2(0, 0), Vec2(4, 4)}, 4);
  const std::size_t corner = 3 * 4;  // lower left
  EXPECT_EQ(relief.height[corner], 5.0);
  EXPECT_EQ(relief.zone[corner], 1);
}

TEST(Ticks, AreRoundAndInside) {
  const Ticks marks = ticks(-3.2, 47.9, 7);
  EXPECT_EQ(marks.step, 10.0);
  EXPECT_EQ(marks.values, (std::vector<double>{0.0, 10.0, 20.0, 30.0, 40.0}));
  EXPECT_EQ(ticks(0.0, 0.5, 5).decimals, 1);
  EXPECT_EQ(ticks(6500000.0, 6500100.0, 5).values.front(), 6500000.0);
}

TEST(Ticks, EndOnRangesThatHaveNoWidth) {
  EXPECT_EQ(ticks(3.0, 3.0, 5).values.size(), 1u);
  EXPECT_EQ(ticks(1e9, std::nextafter(1e9, 2e9), 5).values.size(), 1u);
  EXPECT_EQ(ticks(0.0, INFINITY, 5).values.size(), 1u);
}

TEST(PageNumbers, AreWrittenAsAReaderExpects) {
  EXPECT_EQ(fixed(-0.04, 1), "0.0");
  EXPECT_EQ(fixed(NAN, 1), "-");
  EXPECT_EQ(significant(1474.68, 4), "1475");
  EXPECT_EQ(significant(0.012345, 3), "0.0123");
  EXPECT_EQ(significant(9.996, 3), "10.0");
  EXPECT_EQ(significant(8.7e7, 3), "8.70e+07");
  EXPECT_EQ(percent(0.03125), "3.1 %");
  EXPECT_EQ(escaped("a<b & \"c\">'\x01"), "a&lt;b &amp; &quot;c&quot;&gt;&#39;");
}

TEST(ZoneTint, FollowsTheNameWhenItIsAColour) {
  EXPECT_EQ(zone_tint("Blue", 3), zone_tint("blue", 0));
  EXPECT_NE(zone_tint("blue", 0), zone_tint("red", 0));
  EXPECT_NE(zone_tint("scree", 0), zone_tint("rock", 1));
}

}  // namespace
}  // namespace clast
