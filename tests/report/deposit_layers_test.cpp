/// Map layers of a deposit as GDAL reads them back.
#include "report/gdal/deposit_layers.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast::report_detail {
namespace {

DepositMapBlock block_with_axis(const std::string& id, const Vec3& long_axis) {
  return {.id = id,
          .axes = {0.8, 0.6, 0.3},
          .volume = 0.075,
          .mass = 200.0,
          .visible_fraction = 0.6,
          .confidence = 0.9,
          .points = 1200,
          .centre = {652010.0, 5203001.0, 1824.5},
          .long_axis = long_axis,
          .outlines = {{{652009.0, 5203000.0}, {652011.0, 5203000.0}, {652010.0, 5203002.0}}}};
}

DepositMap sample_map() {
  return {.crs = "EPSG:25832",
          .blocks = {block_with_axis("talus_1", Vec3(1.0, 0.0, -1.0)),
                     block_with_axis("talus_2", Vec3(0.0, -1.0, 0.0))},
          .left_out = {{{652000.0, 5203005.0, 1820.0}, 90, "too few points"}}};
}

class DepositLayers : public testing::Test {
 protected:
  void open(const DepositMap& map) {
    write_deposit_layers(path_, map, {.kind = "SQLite", .replace = true});
    dataset_.reset(GDALDataset::Open(path_.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    ASSERT_NE(dataset_, nullptr);
  }
  OGRFeatureUniquePtr first(const char* layer) {
    return OGRFeatureUniquePtr(dataset_->GetLayerByName(layer)->GetNextFeature());
  }
  ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "deposit.gpkg";
  GDALDatasetUniquePtr dataset_;
};

TEST_F(DepositLayers, HaveOutlinesCentresAndPartsLeftOut) {
  open(sample_map());
  ASSERT_NE(dataset_->GetLayerByName("outlines"), nullptr);
  EXPECT_EQ(dataset_->GetLayerByName("outlines")->GetFeatureCount(), 2);
  EXPECT_EQ(dataset_->GetLayerByName("centres")->GetFeatureCount(), 2);
  EXPECT_EQ(dataset_->GetLayerByName("left_out")->GetFeatureCount(), 1);
  EXPECT_STREQ(dataset_->GetLayerByName("outlines")->GetSpatialRef()->GetAuthorityCode(nullptr),
               "25832");
  const OGRFeatureUniquePtr outline = first("outlines");
  EXPECT_STREQ(outline->GetFieldAsString("block"), "talus_1");
  EXPECT_EQ(outline->GetFieldAsDouble("I_m"), 0.6);
  EXPECT_EQ(outline->GetFieldAsDouble("mass_kg"), 200.0);
  EXPECT_STREQ(outline->GetFieldAsString("class"), sneed_folk_class({0.8, 0.6, 0.3}).c_str());
  EXPECT_EQ(outline->GetFieldAsDouble("visible_fraction"), 0.6);
  EXPECT_EQ(outline->GetFieldAsDouble("confidence"), 0.9);
  EXPECT_EQ(outline->GetFieldAsInteger64("points"), 1200);
  EXPECT_NEAR(outline->GetGeometryRef()->toMultiPolygon()->get_Area(), 2.0, 1e-9);
  const OGRFeatureUniquePtr centre = first("centres");
  EXPECT_EQ(centre->GetGeometryRef()->toPoint()->getZ(), 1824.5);
  const OGRFeatureUniquePtr part = first("left_out");
  EXPECT_STREQ(part->GetFieldAsString("reason"), "too few points");
  EXPECT_EQ(part->GetFieldAsInteger64("points"), 90);
  EXPECT_EQ(part->GetGeometryRef()->toPoint()->getX(), 652000.0);
}

TEST_F(DepositLayers, HaveTrendAndPlungeOfTheLowerEnd) {
  DepositMap map = sample_map();
  map.blocks = {block_with_axis("east", {1.0, 0.0, -1.0}), block_with_axis("west", {1.0, 0.0, 1.0}),
                block_with_axis("south", {0.0, -2.0, -0.02}),
                block_with_axis("down", {0.0, 0.0, 3.0})};
  open(map);
  OGRLayer* layer = dataset_->GetLayerByName("centres");
  const std::vector<std::pair<double, double>> expected = {
      {90.0, 45.0}, {270.0, 45.0}, {180.0, 0.573}};
  for (const auto& [trend, plunge] : expected) {
    const OGRFeatureUniquePtr feature(layer->GetNextFeature());
    EXPECT_NEAR(feature->GetFieldAsDouble("trend_deg"), trend, 1e-9);
    EXPECT_NEAR(feature->GetFieldAsDouble("plunge_deg"), plunge, 1e-3);
  }
  const OGRFeatureUniquePtr vertical(layer->GetNextFeature());
  EXPECT_NEAR(vertical->GetFieldAsDouble("plunge_deg"), 90.0, 1e-9);
}

TEST_F(DepositLayers, HaveNoDegreesWithoutAReferenceSystem) {
  DepositMap map = sample_map();
  map.crs.clear();
  open(map);
  const OGRSpatialReference* system = dataset_->GetLayerByName("outlines")->GetSpatialRef();
  ASSERT_NE(system, nullptr);
  EXPECT_FALSE(system->IsGeographic());
  EXPECT_EQ(system->GetLinearUnits(), 1.0);
}

TEST_F(DepositLayers, OfUnknownConfidenceHaveNone) {
  DepositMap map = sample_map();
  map.blocks[0].confidence = map.blocks[0].visible_fraction = NAN;
  map.blocks[0].outlines.clear();
  open(map);
  const OGRFeatureUniquePtr outline = first("outlines");
  EXPECT_FALSE(outline->IsFieldSetAndNotNull(outline->GetFieldIndex("confidence")));
  EXPECT_FALSE(outline->IsFieldSetAndNotNull(outline->GetFieldIndex("visible_fraction")));
}

TEST_F(DepositLayers, HaveStylesForQgis) {
  open(sample_map());
  OGRLayer* styles = dataset_->GetLayerByName("layer_styles");
  ASSERT_NE(styles, nullptr);
  EXPECT_EQ(styles->GetFeatureCount(), 3);
  const OGRFeatureUniquePtr style(styles->GetNextFeature());
  EXPECT_STREQ(style->GetFieldAsString("f_table_name"), "outlines");
  const std::string qml = style->GetFieldAsString("styleQML");
  EXPECT_TRUE(contains(qml, "SimpleFill"));
  EXPECT_TRUE(contains(qml, "uncertain outline"));
}

TEST_F(DepositLayers, AreEqualForEqualDeposits) {
  open(sample_map());
  dataset_.reset();
  const std::string once = read_text_file(path_);
  open(sample_map());
  dataset_.reset();
  EXPECT_EQ(read_text_file(path_), once);
}

TEST_F(DepositLayers, ReplaceOnlyWhatTheyMay) {
  write_text_file(path_, "notes");
  EXPECT_FALSE(
      refusal([&] { write_deposit_layers(path_, sample_map(), {.kind = "SQLite"}); }).empty());
  EXPECT_EQ(read_text_file(path_), "notes");
}

}  // namespace
}  // namespace clast::report_detail
