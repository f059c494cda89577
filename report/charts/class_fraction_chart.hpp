#pragma once
/// Chart of class fractions with their intervals (SVG).
#include <string>
#include <vector>

namespace clast::report_detail {

/// Fraction in [0, 1] with its 95 % interval.
struct FractionWithInterval {
  double value = 0.0;
  double low = 0.0;
  double high = 1.0;
  std::string note;  ///< tooltip
};

/// Series of class fractions, such as those of one population.
struct ClassFractionSeries {
  std::string name;
  std::string colour;
  std::vector<FractionWithInterval> shares;  ///< fraction of each class
};

/// Draws class fractions as bars with intervals as whiskers, one row per class.
std::string draw_class_fractions(const std::string& title, const std::vector<std::string>& classes,
                                 const std::vector<ClassFractionSeries>& series);

}  // namespace clast::report_detail
