#include "classify/certainty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "classify/possible_classes.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

// A ratio this close to a limit is next to it, whatever the axes are known to.
constexpr double kNear = 0.05;

}  // namespace

ClassCertainty assess_class_certainty(const std::string& scheme, const Axes& axes,
                                      double axis_error, const SchemeOptions& options) {
  if (!(axis_error >= 0.0) || !std::isfinite(axis_error)) {
    throw InputError("the error of the axes is " + format_significant(axis_error, 6) +
                     " m; it must be zero or positive");
  }
  ClassCertainty certainty;
  certainty.name = shape_class(scheme, axes, options);
  certainty.distance = std::numeric_limits<double>::infinity();
  for (const ClassifyingRatio& ratio : classifying_ratios(scheme, axes, options)) {
    for (const double limit : ratio.limits) {
      const double distance = std::abs(ratio.value - limit);
      if (distance >= certainty.distance) continue;
      certainty.nearest_ratio = ratio.name;
      certainty.ratio_value = ratio.value;
      certainty.nearest_limit = limit;
      certainty.distance = distance;
    }
  }
  if (axis_error > 0.0) {
    certainty.other_possible_classes = find_possible_classes(scheme, axes, axis_error, options);
    std::erase(certainty.other_possible_classes, certainty.name);
  }
  certainty.is_certain = certainty.other_possible_classes.empty();
  certainty.near_limit = certainty.distance < kNear || !certainty.is_certain;
  return certainty;
}

std::string describe_certainty(const ClassCertainty& certainty) {
  std::string text = certainty.nearest_ratio + " " + format_significant(certainty.ratio_value, 3) +
                     " is " + format_significant(certainty.distance, 2) + " from " +
                     format_significant(certainty.nearest_limit, 3);
  if (certainty.is_certain) return text;
  text += "; ";
  for (const std::string& name : certainty.other_possible_classes) {
    text += name + (&name == &certainty.other_possible_classes.back() ? " possible" : ", ");
  }
  return text;
}

}  // namespace clast
