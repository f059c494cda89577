#include "report/maps/raster_files.hpp"

#include <cmath>

#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/version.hpp"
#include "report/maps/detail/gdal_output.hpp"
#include "report/maps/qgis_styles.hpp"

namespace clast::report_detail {
namespace {

constexpr float kNoData = -9999.0F;

void write_layer(const std::filesystem::path& path, const MapRasters& rasters,
                 const RasterLayer& layer, const OGRSpatialReference& crs) {
  OutputFile output(path);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  check_written(driver != nullptr, path, "a GeoTIFF: this GDAL has no driver for it");
  const char* options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", nullptr};
  Dataset dataset(driver->Create(output.temporary().string().c_str(),
                                 static_cast<int>(rasters.columns), static_cast<int>(rasters.rows),
                                 1, GDT_Float32, const_cast<char**>(options)));
  check_written(dataset != nullptr, path, "a GeoTIFF");
  double transform[] = {
      rasters.corner.x(), rasters.cell, 0.0, rasters.corner.y() + rasters.cell * rasters.rows, 0.0,
      -rasters.cell};
  check_written(dataset->SetGeoTransform(transform) == CE_None, path, "its place on the map");
  check_written(dataset->SetSpatialRef(&crs) == CE_None, path, "its map system");
  dataset->SetMetadataItem("TIFFTAG_SOFTWARE", (std::string("clast ") + version()).c_str());
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetNoDataValue(kNoData);
  band->SetDescription(layer.meaning.c_str());
  std::vector<float> cells = layer.value;
  for (float& cell : cells) {
    if (!std::isfinite(cell)) cell = kNoData;
  }
  check_written(band->RasterIO(GF_Write, 0, 0, static_cast<int>(rasters.columns),
                               static_cast<int>(rasters.rows), cells.data(),
                               static_cast<int>(rasters.columns), static_cast<int>(rasters.rows),
                               GDT_Float32, 0, 0, nullptr) == CE_None,
                path, "its cells");
  CPLErrorReset();
  dataset.reset();
  check_written(CPLGetLastErrorType() < CE_Failure, path, "a GeoTIFF");
  output.commit();
}

}  // namespace

std::vector<std::filesystem::path> write_rasters(const std::filesystem::path& folder,
                                                 const MapRasters& rasters,
                                                 const std::string& crs_name) {
  const QuietGdal quiet;
  CPLErrorReset();
  GDALAllRegister();
  const OGRSpatialReference crs = reference_of(crs_name);
  const std::vector<ValueStyle> styles = value_styles(rasters);
  std::vector<std::filesystem::path> written;
  for (std::size_t i = 0; i < rasters.layers.size(); ++i) {
    const RasterLayer& layer = rasters.layers[i];
    written.push_back(folder / (layer.name + ".tif"));
    write_layer(written.back(), rasters, layer, crs);
    written.push_back(folder / (layer.name + ".qml"));
    write_text_file(written.back(), raster_qml(styles[i]));
  }
  return written;
}

}  // namespace clast::report_detail
