/// GeoPackages and pictures as GDAL reads them back.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <memory>

#include "core/error.hpp"
#include "core/files/png.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/gdal/geopackage.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

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
  for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(random.uniform_index(200));
  std::vector<Rgb> palette;
  for (int i = 0; i < 200; ++i) {
    palette.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 7});
  }
  write_text_file(folder / "a.png", encode_palette_png(width, height, pixels, palette));
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
      part = static_cast<std::uint8_t>(noisy ? random.uniform_index(256) : i % width);
    }
  }
  write_text_file(folder / "a.png", encode_rgb_png(width, height, pixels));
  const Dataset dataset(
      GDALDataset::Open((folder / "a.png").c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  ASSERT_NE(dataset, nullptr);
  ASSERT_EQ(dataset->GetRasterCount(), 3);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<std::uint8_t> back(pixels.size());
    ASSERT_EQ(
        dataset->GetRasterBand(channel + 1)
            ->RasterIO(GF_Read, 0, 0, width, height, back.data(), width, height, GDT_Byte, 0, 0),
        CE_None);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      ASSERT_EQ(back[i], pixels[i][static_cast<std::size_t>(channel)]) << i;
    }
  }
}

}  // namespace
}  // namespace clast
