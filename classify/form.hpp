#pragma once
/// Form ratios and indices from the axes L >= I >= S.
#include <map>
#include <optional>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Axes of a block, m.
struct Axes {
  double L = 0.0;
  double I = 0.0;
  double S = 0.0;

  /// Sorted so that L >= I >= S.
  /// @throws InputError  a value that is zero, negative or not finite
  static Axes sorted(double a, double b, double c);
};

/// s_c = L/I - 1. @cite garcia2022
double elongation_s_c(const Axes& axes);
/// (L - I)/(L - S); none for L = S. @cite sneed1958
std::optional<double> disc_rod_index(const Axes& axes);
/// (S^2/(L I))^(1/3). @cite sneed1958
double maximum_projection_sphericity(const Axes& axes);
/// (I S/L^2)^(1/3). @cite krumbein1941
double intercept_sphericity(const Axes& axes);
/// S/sqrt(L I). @cite corey1949
double corey_shape_factor(const Axes& axes);

/// All of the above and L/I, S/I, I/L, S/L under their documented names, for tables and JSON.
std::map<std::string, double> form_indices(const Axes& axes);

}  // namespace clast
