#pragma once
/// Numbers that stand for "no height" in a grid that does not say so.
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {

/// What is known of the gaps of a grid, and what to do about those that are not declared.
struct NoDataRules {
  std::optional<double> declared = {};  ///< value for no data that the file names
  /// Completes "If -9999 stands for no data, ..."; NUMBER stands for the value.
  std::string advice;
};

/// Refuses heights that are none on earth, and those of the usual fill values (-9999, 9999, -999,
/// -99, 0 and others alike) that lie farther from all other heights than these span, 0 by more than
/// 100 m too. Where a value for no data is declared, such heights are noted with their count, and
/// so are usual fill values and repeated lowest or highest heights whose cells border on steps ten
/// times the mean step between cells.
/// @return notes
/// @throws InputError  with value, count and a place
std::vector<std::string> check_fill_values(const HeightGrid& grid,
                                           const std::filesystem::path& path,
                                           const NoDataRules& rules);

/// The heights of a cloud's points: those of usual fill values, and the range of the others.
class PointHeightCheck {
 public:
  void include(double height);
  void include(const PointHeightCheck& other);
  /// Refuses usual fill values that lie farther from all other heights than these span, 0 by more
  /// than 100 m too.
  /// @throws InputError  with value and count
  void check(const std::filesystem::path& path) const;

 private:
  std::map<double, std::size_t> fills_;  ///< points of each value
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

}  // namespace clast::terrain_detail
