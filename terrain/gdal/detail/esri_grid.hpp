#pragma once
/// Esri grids in text, as GDAL has to find them. For .cpp files only.
#include <filesystem>
#include <string>
#include <vector>

namespace clast::terrain_detail {

/// An Esri grid that GDAL reads right. GDAL passes over rows that begin with a letter, as in "nan",
/// and takes other words for 0; a grid whose heights begin so is given to it as a copy in memory,
/// with what its .prj and .aux.xml files say.
class EsriGrid {
 public:
  /// @param path  a raster of any kind; other kinds than Esri grids stay as they are
  /// @throws InputError  a word among the heights that is no number
  explicit EsriGrid(const std::filesystem::path& path);
  ~EsriGrid();
  EsriGrid(const EsriGrid&) = delete;
  EsriGrid& operator=(const EsriGrid&) = delete;

  /// What GDAL is to open.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> copies_;  ///< in memory
};

}  // namespace clast::terrain_detail
