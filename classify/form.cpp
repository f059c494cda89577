#include "classify/form.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

Axes Axes::sorted(double a, double b, double c) {
  std::array<double, 3> values = {a, b, c};
  for (const double value : values) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw InputError("axes " + with_digits(a, 6) + ", " + with_digits(b, 6) + ", " +
                     with_digits(c, 6) + " m: each must be a positive, finite length");
  }
  std::sort(values.begin(), values.end());
  return {values[2], values[1], values[0]};
}

double elongation_s_c(const Axes& axes) { return axes.L / axes.I - 1.0; }

std::optional<double> disc_rod_index(const Axes& axes) {
  if (!(axes.L > axes.S)) return std::nullopt;
  return (axes.L - axes.I) / (axes.L - axes.S);
}

double maximum_projection_sphericity(const Axes& axes) {
  return std::cbrt(axes.S * axes.S / (axes.L * axes.I));
}

double intercept_sphericity(const Axes& axes) {
  return std::cbrt(axes.I * axes.S / (axes.L * axes.L));
}

double corey_shape_factor(const Axes& axes) { return axes.S / std::sqrt(axes.L * axes.I); }

std::map<std::string, double> form_indices(const Axes& axes) {
  std::map<std::string, double> indices = {
      {"L/I", axes.L / axes.I},
      {"I/L", axes.I / axes.L},
      {"S/I", axes.S / axes.I},
      {"S/L", axes.S / axes.L},
      {"s_c", elongation_s_c(axes)},
      {"maximum_projection_sphericity", maximum_projection_sphericity(axes)},
      {"intercept_sphericity", intercept_sphericity(axes)},
      {"corey_shape_factor", corey_shape_factor(axes)},
  };
  if (const auto index = disc_rod_index(axes)) indices["disc_rod_index"] = *index;
  return indices;
}

}  // namespace clast
