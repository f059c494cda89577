#pragma once
/// Form ratios and indices from the axes L >= I >= S.
#include <map>
#include <optional>
#include <span>
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
double elongation_index(const Axes& axes);
/// (L - I)/(L - S); none for L = S. @cite sneed1958
std::optional<double> disc_rod_index(const Axes& axes);
/// (S^2/(L I))^(1/3). @cite sneed1958
double maximum_projection_sphericity(const Axes& axes);
/// (I S/L^2)^(1/3). @cite krumbein1941
double intercept_sphericity(const Axes& axes);
/// S/sqrt(L I). @cite corey1949
double corey_shape_factor(const Axes& axes);
/// 1 - L S/I^2 where I^2 >= L S (oblate, up to 1), else I^2/(L S) - 1 (prolate, down to -1).
/// @cite williams1965
double williams_shape_index(const Axes& axes);
/// 12.8 (p^2 q)^(1/3) / (1 + p (1 + q) + 6 sqrt(1 + p^2 (1 + q^2))) with p = S/I, q = I/L.
/// @cite aschenbrenner1956
double aschenbrenner_working_sphericity(const Axes& axes);
/// 10 ((L - I)/(L - S) - 0.5) / (S/L): negative disc-like, positive rod-like; none for L = S.
/// @cite dobkins1970
std::optional<double> oblate_prolate_index(const Axes& axes);

/// Place in the triangle of Sneed & Folk; the three add up to 1. L = S is the compact corner.
/// @cite sneed1958 @cite graham2000
struct TernaryCoordinates {
  double compact = 0.0;   ///< q = S/L
  double elongate = 0.0;  ///< (1 - q) (L - I)/(L - S)
  double platy = 0.0;     ///< (1 - q) (I - S)/(L - S)
};
TernaryCoordinates ternary_coordinates(const Axes& axes);

/// One index of a block's form.
struct FormIndex {
  const char* name;     ///< as in tables and JSON
  const char* formula;  ///< in L, I, S
  const char* source;   ///< key in docs/references.bib; empty for a plain ratio
  std::optional<double> (*value)(const Axes&);
};

/// Every index, in the order it is listed in docs/theory.md.
std::span<const FormIndex> form_index_definitions();

/// The values of all that are defined for these axes, by name.
std::map<std::string, double> form_indices(const Axes& axes);

}  // namespace clast
