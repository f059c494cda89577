// Classes and colours of map layers, and the same in the files that QGIS reads.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>
#include <regex>
#include <set>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/gdal/geopackage.hpp"
#include "report/maps/map_style.hpp"
#include "report/maps/qgis_styles.hpp"
#include "report/maps/raster_files.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

MapRasterSet rasters_with(std::vector<RasterLayer> layers) {
  MapRasterSet rasters;
  rasters.columns = static_cast<std::uint32_t>(layers.front().values.size());
  rasters.rows = 1;
  rasters.layers = std::move(layers);
  return rasters;
}

ColourScale style_of(const std::string& layer, std::vector<float> values) {
  return choose_colour_scales(rasters_with({{layer, "", std::move(values)}})).front();
}

using Numbers = std::vector<std::string>;

TEST(MapStyle, EnergiesHaveTheLimitsOfHazardMaps) {
  const ColourScale style = style_of("E_95", {2.5e3F, 6e4F, 2.9e5F, NAN});
  EXPECT_EQ(style.unit, "kJ");
  EXPECT_EQ(style.numbers, (Numbers{"3", "10", "30", "100", "300"}));
  EXPECT_EQ(style.breaks[2], 30e3);
  EXPECT_EQ(style.label(0), "up to 3 kJ");
  EXPECT_EQ(style.label(3), "30 to 100 kJ");
  // Of pebbles in joules.
  EXPECT_EQ(style_of("E_95", {0.25F, 0.9F}).numbers, (Numbers{"0.3", "1"}));
  EXPECT_EQ(style_of("E_95", {0.25F, 0.9F}).unit, "J");
}

TEST(MapStyle, LayersOfOneQuantityHaveTheSameLimits) {
  const auto styles = choose_colour_scales(rasters_with(
      {{"E_mean", "", {2e3F, 5e3F}}, {"E_max", "", {8e3F, 9e4F}}, {"V_max", "", {8.0F, 9.0F}}}));
  EXPECT_EQ(styles[0].breaks, styles[1].breaks);
  EXPECT_EQ(styles[0].numbers, (Numbers{"3", "10", "30", "100"}));
  EXPECT_NE(styles[0].breaks, styles[2].breaks);
}

TEST(MapStyle, CountsAndSharesHaveOneTwoFiveAndOthersEvenLimits) {
  EXPECT_EQ(style_of("Nr_passages", {1.0F, 2.0F, 37.0F}).numbers,
            (Numbers{"1", "2", "5", "10", "20", "50"}));
  const ColourScale reach = style_of("Reach_probability", {0.002F, 1.0F});
  EXPECT_EQ(reach.unit, "%");
  EXPECT_EQ(reach.numbers, (Numbers{"0.5", "1", "2", "5", "10", "20", "50", "100"}))
      << "eight classes at most, the rare ones together";
  EXPECT_EQ(style_of("V_max", {0.5F, 11.5F}).numbers, (Numbers{"2", "4", "6", "8", "10", "12"}));
  EXPECT_EQ(style_of("Ph_95", {0.31F, 0.42F}).numbers, (Numbers{"0.4", "0.5"}));
}

/// The class of a value, as page and QGIS find it: the first limit that is not below.
std::size_t class_of(const ColourScale& style, float value) {
  std::size_t k = 0;
  while (k < style.breaks.size() && static_cast<double>(value) > style.breaks[k]) ++k;
  return k;
}

TEST(MapStyle, EveryValueHasAClassAndTheOutermostAreNotEmpty) {
  Random random(7);
  for (const char* name : {"E_max", "Nr_passages", "Reach_probability", "V_max", "other"}) {
    for (int trial = 0; trial < 300; ++trial) {
      const double largest = std::pow(10.0, random.uniform(-4.0, 7.0));
      std::vector<float> values = {static_cast<float>(largest)};
      for (int i = 0; i < 5; ++i) {
        values.push_back(static_cast<float>(largest * std::pow(10.0, random.uniform(-3.0, 0.0))));
      }
      const ColourScale style = style_of(name, values);
      ASSERT_FALSE(style.breaks.empty());
      ASSERT_LE(style.breaks.size(), 8u);
      EXPECT_EQ(style.colours.size(), style.breaks.size());
      EXPECT_EQ(std::set<Rgb>(style.colours.begin(), style.colours.end()).size(),
                style.colours.size());
      EXPECT_TRUE(std::is_sorted(style.breaks.begin(), style.breaks.end()));
      std::set<std::size_t> classes;
      for (const float value : values) classes.insert(class_of(style, value));
      EXPECT_EQ(*classes.rbegin() + 1, style.breaks.size()) << name << " " << largest;
      if (style.breaks.size() == 8) continue;  // rare small values share the lowest class
      EXPECT_EQ(*classes.begin(), 0u) << name << " " << largest;
    }
  }
}

// A share of 0.2 is a little more as a 32-bit float, and a limit of 20 % includes it.
TEST(MapStyle, AValueOnALimitBelongsToTheClassBelow) {
  const std::vector<float> shares = {0.01F, 0.02F, 0.05F, 0.1F, 0.2F, 0.5F, 1.0F};
  const ColourScale style = style_of("Reach_probability", shares);
  ASSERT_EQ(style.breaks.size(), shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_EQ(class_of(style, shares[i]), i);
  EXPECT_EQ(style_of("E_mean", {0.0F, 0.0F}).breaks.size(), 1u) << "nothing but zeros";
}

TEST(MapStyle, BlocksOfAClassDifferInShapeAndClassesInColour) {
  const StopMarks stops = choose_stop_marks(compared(hand_made_results()));
  EXPECT_TRUE(stops.by_block);
  ASSERT_EQ(stops.marks.size(), 2u);
  EXPECT_NE(stops.marks[0].colour, stops.marks[1].colour);
  CampaignResults many = hand_made_results();
  while (many.blocks.size() < 10) {
    many.blocks.push_back(many.blocks[0]);
    many.blocks.back().id += std::to_string(many.blocks.size());
    const auto run = static_cast<std::uint32_t>(many.runs.size());
    const auto block = static_cast<std::uint32_t>(many.blocks.size() - 1);
    many.runs.push_back(hand_made_run(run, block, 10.0, 0.0));
  }
  std::set<std::string> seen;
  for (const StopMark& mark : choose_stop_marks(compared(std::move(many))).marks) {
    seen.insert(mark.colour + mark.shape.plotly);
  }
  EXPECT_EQ(seen.size(), 10u);
}

/// Values of an attribute, in order.
std::vector<std::string> attributes(const std::string& xml, const std::string& tag,
                                    const std::string& name) {
  std::vector<std::string> values;
  const std::regex pattern("<" + tag + " [^>]*\\b" + name + "=\"([^\"]*)\"");
  for (std::sregex_iterator it(xml.begin(), xml.end(), pattern), end; it != end; ++it) {
    values.push_back((*it)[1]);
  }
  return values;
}

TEST(QgisStyles, ARasterHasTheClassesOfThePage) {
  const ScratchFolder folder;
  const MapRasterSet rasters = rasters_with({{"Reach_probability", "", {0.003F, 0.2F, 0.7F}}});
  const auto files = write_rasters(folder.path(), rasters, "EPSG:2154");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1], folder / "Reach_probability.qml");
  const std::string qml = read_text_file(files[1]);
  EXPECT_TRUE(contains(qml, "<!DOCTYPE qgis"));
  EXPECT_EQ(attributes(qml, "rasterrenderer", "type"),
            std::vector<std::string>{"singlebandpseudocolor"});
  EXPECT_EQ(attributes(qml, "colorrampshader", "colorRampType"),
            std::vector<std::string>{"DISCRETE"});
  const ColourScale style = choose_colour_scales(rasters).front();
  const std::vector<std::string> values = attributes(qml, "item", "value");
  const std::vector<std::string> labels = attributes(qml, "item", "label");
  const std::vector<std::string> colours = attributes(qml, "item", "color");
  ASSERT_EQ(values.size(), style.breaks.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::stod(values[i]), style.breaks[i]) << "to the last bit";
    EXPECT_EQ(labels[i], style.label(i));
    EXPECT_EQ(colours[i].size(), 7u);
  }
}

struct Closing {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

TEST(QgisStyles, EveryLayerOfTheGeoPackageHasItsDefaultStyle) {
  const ScratchFolder folder;
  write_geopackage(folder / "stops.gpkg", compared(hand_made_results()));
  const std::unique_ptr<GDALDataset, Closing> dataset(
      GDALDataset::Open((folder / "stops.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  ASSERT_NE(dataset, nullptr);
  OGRLayer* table = dataset->GetLayerByName("layer_styles");
  ASSERT_NE(table, nullptr);
  EXPECT_STREQ(table->GetFIDColumn(), "id");
  std::map<std::string, std::string> styles;
  for (const auto& row : *table) {
    const std::string layer = row->GetFieldAsString("f_table_name");
    ASSERT_NE(dataset->GetLayerByName(layer.c_str()), nullptr) << layer;
    EXPECT_STREQ(row->GetFieldAsString("f_geometry_column"),
                 dataset->GetLayerByName(layer.c_str())->GetGeometryColumn());
    // QGIS asks for rows whose catalogue and schema are empty, which NULL is not.
    EXPECT_TRUE(row->IsFieldSetAndNotNull(row->GetFieldIndex("f_table_schema")));
    EXPECT_STREQ(row->GetFieldAsString("f_table_schema"), "");
    EXPECT_EQ(row->GetFieldAsInteger("useAsDefault"), 1);
    styles[layer] = row->GetFieldAsString("styleQML");
  }
  ASSERT_EQ(styles.size(), 4u) << "stops, crossings, barriers, trajectories";
  const std::vector<std::string> stops = attributes(styles["stops"], "category", "value");
  EXPECT_EQ(stops, (std::vector<std::string>{"round&lt;1&gt;", "long, &quot;2&quot;"}));
  EXPECT_EQ(attributes(styles["trajectories"], "category", "value"),
            (std::vector<std::string>{"compact", "elongated"}));
  EXPECT_TRUE(contains(styles["barriers"], "fieldName=\"name\""));
}

}  // namespace
}  // namespace clast
