#pragma once
/// Esri grids read by a second method, not through GDAL.
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Cell-centre registered; lengths in m.
struct AscGrid {
  int columns = 0, rows = 0;
  double west = 0.0, south = 0.0, cell = 0.0, nodata = 0.0;
  std::vector<double> values;  ///< north row first

  explicit AscGrid(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string key;
    file >> key >> columns >> key >> rows >> key >> west >> key >> south >> key >> cell >> key >>
        nodata;
    for (double value; file >> value;) values.push_back(value);
  }
  Vec2 centre(std::size_t index) const {
    const int i = static_cast<int>(index) % columns, j = static_cast<int>(index) / columns;
    return {west + cell * (i + 0.5), south + cell * (rows - j - 0.5)};
  }
  std::size_t index(int column, int row_from_south) const {
    return static_cast<std::size_t>((rows - 1 - row_from_south) * columns + column);
  }
  std::optional<double> at(int column, int row_from_south) const {
    if (column < 0 || row_from_south < 0 || column >= columns || row_from_south >= rows) return {};
    const double value = values[index(column, row_from_south)];
    return value == nodata ? std::nullopt : std::optional(value);
  }
};

}  // namespace clast
