#include "classify/certainty.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

// An axis is never taken thinner than this share of itself, however large the error.
constexpr double kThinnest = 1e-6;

// A ratio this close to a limit is next to it, whatever the axes are known to.
constexpr double kNear = 0.05;

/// Corners of the set of axes within the error that are in order. At a corner each axis is at one
/// end of its range, or equal to a neighbour that is.
std::vector<Axes> extreme_axes(const Axes& axes, double error) {
  const auto low = [&](double axis) { return std::max(axis - error, kThinnest * axis); };
  const std::array<double, 6> ends = {axes.L + error, low(axes.L),    axes.I + error,
                                      low(axes.I),    axes.S + error, low(axes.S)};
  const auto within = [&](double value, double axis) {
    return value >= low(axis) && value <= axis + error;
  };
  std::vector<Axes> corners;
  for (const double L : ends) {
    if (!within(L, axes.L)) continue;
    for (const double I : ends) {
      if (I > L || !within(I, axes.I)) continue;
      for (const double S : ends) {
        if (S <= I && within(S, axes.S)) corners.push_back({L, I, S});
      }
    }
  }
  return corners;
}

/// Between which limits each ratio lies. Equal cells are one class.
std::vector<std::size_t> cell(const std::string& scheme, const Axes& axes,
                              const SchemeOptions& options) {
  std::vector<std::size_t> places;
  for (const SchemeRatio& ratio : scheme_ratios(scheme, axes, options)) {
    const auto place = std::upper_bound(ratio.limits.begin(), ratio.limits.end(), ratio.value);
    places.push_back(static_cast<std::size_t>(place - ratio.limits.begin()));
  }
  return places;
}

}  // namespace

ClassCertainty class_certainty(const std::string& scheme, const Axes& axes, double axis_error,
                               const SchemeOptions& options) {
  if (!(axis_error >= 0.0) || !std::isfinite(axis_error)) {
    throw InputError("the error of the axes is " + with_digits(axis_error, 6) +
                     " m; it must be zero or positive");
  }
  ClassCertainty certainty;
  certainty.name = shape_class(scheme, axes, options);
  certainty.distance = std::numeric_limits<double>::infinity();
  for (const SchemeRatio& ratio : scheme_ratios(scheme, axes, options)) {
    for (const double limit : ratio.limits) {
      const double distance = std::abs(ratio.value - limit);
      if (distance >= certainty.distance) continue;
      certainty.ratio = ratio.name;
      certainty.value = ratio.value;
      certainty.limit = limit;
      certainty.distance = distance;
    }
  }
  certainty.near_limit = certainty.distance < kNear;
  if (axis_error == 0.0) return certainty;
  const auto here = cell(scheme, axes, options);
  for (const Axes& other : extreme_axes(axes, axis_error)) {
    certainty.survives = certainty.survives && cell(scheme, other, options) == here;
    const std::string name = shape_class(scheme, other, options);
    if (name == certainty.name) continue;
    certainty.survives = false;
    if (std::find(certainty.others.begin(), certainty.others.end(), name) ==
        certainty.others.end()) {
      certainty.others.push_back(name);
    }
  }
  certainty.near_limit = certainty.near_limit || !certainty.survives;
  const auto& order = class_names(scheme);
  const auto rank = [&](const std::string& name) {
    return std::find(order.begin(), order.end(), name);
  };
  std::sort(certainty.others.begin(), certainty.others.end(),
            [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
  return certainty;
}

std::string described(const ClassCertainty& certainty) {
  std::string text = certainty.ratio + " " + with_digits(certainty.value, 3) + " is " +
                     with_digits(certainty.distance, 2) + " from " +
                     with_digits(certainty.limit, 3);
  if (certainty.survives) return text;
  text += "; ";
  for (const std::string& name : certainty.others) {
    text += name + (&name == &certainty.others.back() ? " possible" : ", ");
  }
  return certainty.others.empty() ? text + "another class possible" : text;
}

}  // namespace clast
