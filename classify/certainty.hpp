#pragma once
/// Certainty of a shape class in view of the measurement error of the axes.
#include <string>
#include <vector>

#include "classify/schemes.hpp"

namespace clast {

/// Error of an axis measured by tape, m.
inline constexpr double kTapeError = 0.05;

/// Shape class with its nearest class limit, and other classes that are possible within the error.
struct ClassCertainty {
  std::string name;
  std::string nearest_ratio;   ///< ratio that is nearest to a class limit, such as "S/L"
  double ratio_value = 0.0;    ///< value of this ratio
  double nearest_limit = 0.0;  ///< class limit nearest to `ratio_value`
  double distance = 0.0;       ///< |ratio_value - nearest_limit|
  bool near_limit =
      false;  ///< true if `distance` is below 0.05, or the limit is within the error of the axes
  bool is_certain = true;  ///< true if the class is the same for all axes within the error
  std::vector<std::string>
      other_possible_classes;  ///< other classes that are possible within the error
};

/// Classifies a block and determines how certain the class is. Each axis has an independent error
/// of up to `axis_error`. `other_possible_classes` is exact: the ratios of all axes L >= I >= S
/// within the error form a convex polygon, which is intersected with the region of each class
/// (docs/theory.md).
/// @param axis_error  m, zero or positive
/// @throws InputError  if the scheme is unknown, or the error negative or not finite
ClassCertainty assess_class_certainty(const std::string& scheme, const Axes& axes,
                                      double axis_error, const SchemeOptions& options = {});

/// Formats the certainty as "S/L 0.698 is 0.002 from 0.7; C possible". The second part is omitted
/// if no other class is possible.
std::string describe_certainty(const ClassCertainty& certainty);

}  // namespace clast
