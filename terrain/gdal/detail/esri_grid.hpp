#pragma once
/// Preparation of Esri ASCII grids for GDAL. Private to .cpp files.
#include <filesystem>
#include <string>
#include <vector>

namespace clast::terrain_detail {

/// Esri grid prepared for GDAL. GDAL skips rows that start with a letter, such as "nan", and reads
/// other words as 0. If the heights start with a word, GDAL gets a copy in memory, with the .prj
/// and .aux.xml files.
class EsriGrid {
 public:
  /// Prepares a raster file for GDAL.
  /// @param path  raster file; files that are not Esri grids are passed on unchanged
  /// @throws InputError  if a word among the heights is not a number
  explicit EsriGrid(const std::filesystem::path& path);
  ~EsriGrid();
  EsriGrid(const EsriGrid&) = delete;
  EsriGrid& operator=(const EsriGrid&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> copies_;  ///< paths of the copies in memory
};

}  // namespace clast::terrain_detail
