#pragma once
/// Shares of classes with their intervals, as SVG.
#include <string>
#include <vector>

namespace clast::report_detail {

/// A share in [0, 1] with its 95 % interval.
struct Share {
  double value = 0.0;
  double low = 0.0;
  double high = 1.0;
  std::string note;  ///< shown when the pointer rests on it
};

/// One way to count, such as a population or by mass.
struct ClassFractionSeries {
  std::string name;
  std::string colour;
  std::vector<Share> shares;  ///< of each class
};

/// A row for every class, also those without a block: bars from zero, intervals as whiskers.
std::string draw_class_fractions(const std::string& title, const std::vector<std::string>& classes,
                        const std::vector<ClassFractionSeries>& series);

}  // namespace clast::report_detail
