#include "report/maps/raster_files.hpp"

#include "core/files/text_file.hpp"
#include "report/maps/qgis_styles.hpp"
#include "terrain/gdal/geotiff_writer.hpp"

namespace clast::report_detail {
std::vector<std::filesystem::path> write_rasters(const std::filesystem::path& folder,
                                                 const MapRasterSet& rasters,
                                                 const std::string& crs) {
  const Vec2 corner(rasters.corner.x(), rasters.corner.y() + rasters.cell_size * rasters.rows);
  const std::vector<ColourScale> styles = choose_colour_scales(rasters);
  std::vector<std::filesystem::path> written;
  for (std::size_t i = 0; i < rasters.layers.size(); ++i) {
    const RasterLayer& layer = rasters.layers[i];
    written.push_back(folder / (layer.name + ".tif"));
    terrain_detail::write_geotiff(written.back(),
                                  {.columns = rasters.columns,
                                   .rows = rasters.rows,
                                   .corner = corner,
                                   .cell = rasters.cell_size,
                                   .values = layer.values,
                                   .meaning = layer.meaning},
                                  crs);
    written.push_back(folder / (layer.name + ".qml"));
    write_text_file(written.back(), format_raster_qml(styles[i]));
  }
  return written;
}

}  // namespace clast::report_detail
