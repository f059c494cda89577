#include "terrain/gdal/geotiff_writer.hpp"

#include <cmath>
#include <vector>

#include "core/version.hpp"
#include "terrain/gdal/detail/gdal_session.hpp"

namespace clast::terrain_detail {

void write_geotiff(const std::filesystem::path& path, const GeoTiffBand& band,
                   const std::string& crs, const OverwritePolicy& rules) {
  constexpr float kNone = -9999.0F;
  const GdalSession session;
  OutputFile output(path, rules);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  check_written(driver != nullptr, path, "a GeoTIFF: this GDAL has no driver for this format");
  const char* options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", nullptr};
  const int columns = static_cast<int>(band.columns), rows = static_cast<int>(band.rows);
  DatasetPointer dataset(driver->Create(output.temporary_path().string().c_str(), columns, rows, 1,
                                        GDT_Float32, const_cast<char**>(options)));
  check_written(dataset != nullptr, path, "a GeoTIFF");
  double transform[] = {band.corner.x(), band.cell, 0.0, band.corner.y(), 0.0, -band.cell};
  check_written(dataset->SetGeoTransform(transform) == CE_None, path, "its place on the map");
  const OGRSpatialReference system = make_spatial_reference(crs);
  check_written(dataset->SetSpatialRef(&system) == CE_None, path, "its map system");
  dataset->SetMetadataItem("TIFFTAG_SOFTWARE", (std::string("clast ") + version()).c_str());
  GDALRasterBand& written = *dataset->GetRasterBand(1);
  check_written(written.SetNoDataValue(kNone) == CE_None, path, "a GeoTIFF");
  if (!band.meaning.empty()) written.SetDescription(band.meaning.c_str());
  std::vector<float> cells(band.values.begin(), band.values.end());
  for (float& cell : cells) {
    if (!std::isfinite(cell)) cell = kNone;
  }
  check_written(written.RasterIO(GF_Write, 0, 0, columns, rows, cells.data(), columns, rows,
                                 GDT_Float32, 0, 0, nullptr) == CE_None,
                path, "its cells");
  // Closing writes the last blocks; only the error state says whether that worked.
  CPLErrorReset();
  dataset.reset();
  check_written(CPLGetLastErrorType() < CE_Failure, path, "a GeoTIFF");
  output.commit();
}

}  // namespace clast::terrain_detail
