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
struct NoDataRules {
  std::optional<double> declared = {};  ///< fill value declared by the file
  /// Advice for messages: the end of a sentence "If -9999 stands for no data, ...". NUMBER in it is
  /// replaced by the value.
  std::string advice;
};

/// Checks for heights that are impossible, and for common fill values (-9999, 9999, -999, -99, 0
/// and similar) farther from all other heights than their range, for 0 also by more than 100 m. If
/// a fill value is declared, they are only noted, as are common fill values and repeated extremes
/// whose cells border on steps ten times the mean step.
/// @return notes
/// @throws InputError  with value, count and a position
std::vector<std::string> check_fill_values(const HeightGrid& grid,
                                           const std::filesystem::path& path,
                                           const NoDataRules& rules);

/// Check of the heights of a point cloud for fill values.
class PointHeightCheck {
 public:
  void include(double height);
  void include(const PointHeightCheck& other);
  /// Checks for suspicious common fill values, as `check_fill_values`.
  /// @throws InputError  if there is one; the message gives value and count
  void check(const std::filesystem::path& path) const;

 private:
  std::map<double, std::size_t> fills_;  ///< number of points for each common fill value
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

}  // namespace clast::terrain_detail
