#pragma once
/// Detection of undeclared fill values in height grids.
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {

/// Declared fill value of a grid, and advice for undeclared ones.
struct DeclaredFillValue {
  std::optional<double> declared = {};  ///< fill value declared by the file
  /// Advice at the end of an error message. "NUMBER" is replaced by the suspicious value.
  std::string advice;
};

/// Checks the heights of a grid for impossible values and undeclared fill values. A common fill
/// value (-9999, 9999, -999, -99, 0 and similar) is suspicious if its distance from all other
/// heights exceeds their range; 0 must also be more than 100 m away. If a fill value is declared,
/// suspicious ones are only noted. Extreme heights and fill values are also noted if the steps
/// around them are ten times the mean step.
/// @return notes
/// @throws InputError  if a height is impossible or suspicious; names value and position
std::vector<std::string> check_fill_values(const HeightGrid& grid,
                                           const std::filesystem::path& path,
                                           const DeclaredFillValue& rules);

/// Check of the heights of a point cloud for undeclared fill values.
class PointFillValueCheck {
 public:
  void include(double height);
  void include(const PointFillValueCheck& other);
  /// Checks if the points include a common fill value far from all other heights.
  /// @throws InputError  if there is one; the message gives value and count
  void check(const std::filesystem::path& path) const;

 private:
  std::map<double, std::size_t> fills_;  ///< number of points for each common fill value
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

}  // namespace clast::terrain_detail
