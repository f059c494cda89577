#pragma once
/// Preparation of Esri ASCII grids for GDAL. Private to .cpp files.
#include <filesystem>
#include <string>
#include <vector>

namespace clast::terrain_detail {

/// Esri grid prepared for GDAL, which skips rows starting with a letter, as in "nan", and reads
/// other words as 0. A grid whose heights start so is passed as a copy in memory, with its .prj and
/// .aux.xml.
class EsriGrid {
 public:
  /// Prepares a raster.
  /// @param path  other kinds than Esri grids are unchanged
  /// @throws InputError  if a word among the heights is not a number
  explicit EsriGrid(const std::filesystem::path& path);
  ~EsriGrid();
  EsriGrid(const EsriGrid&) = delete;
  EsriGrid& operator=(const EsriGrid&) = delete;

  /// Returns the path for GDAL.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> copies_;  ///< in memory
};

}  // namespace clast::terrain_detail
