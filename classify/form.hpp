#pragma once
/// Shape ratios and indices of the axes L >= I >= S.
#include <map>
#include <optional>
#include <span>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Axes L >= I >= S of a block, m.
struct Axes {
  double L = 0.0;
  double I = 0.0;
  double S = 0.0;

  /// Returns the three lengths sorted as L >= I >= S.
  /// @throws InputError  if a value is zero, negative or not finite
  static Axes sorted(double a, double b, double c);
};

/// Elongation s_c = L/I - 1. @cite garcia2022
double elongation_index(const Axes& axes);
/// Disc-rod index (L - I)/(L - S); empty if L = S. @cite sneed1958
std::optional<double> disc_rod_index(const Axes& axes);
/// Maximum projection sphericity (S^2/(L I))^(1/3). @cite sneed1958
double maximum_projection_sphericity(const Axes& axes);
/// Intercept sphericity (I S/L^2)^(1/3). @cite krumbein1941
double intercept_sphericity(const Axes& axes);
/// Corey shape factor S/sqrt(L I). @cite corey1949
double corey_shape_factor(const Axes& axes);
/// Williams index in [-1, 1]: 1 - L S/I^2 if I^2 >= L S (oblate), else I^2/(L S) - 1 (prolate).
/// @cite williams1965
double williams_shape_index(const Axes& axes);
/// Aschenbrenner working sphericity 12.8 (p^2 q)^(1/3) / (1 + p (1 + q) + 6 sqrt(1 + p^2 (1 +
/// q^2))) with p = S/I, q = I/L.
/// @cite aschenbrenner1956
double aschenbrenner_working_sphericity(const Axes& axes);
/// Oblate-prolate index 10 ((L - I)/(L - S) - 0.5)/(S/L), negative for discs; empty if L = S.
/// @cite dobkins1970
std::optional<double> oblate_prolate_index(const Axes& axes);

/// Coordinates in the Sneed-Folk triangle, with sum 1. Blocks with L = S are at the compact corner.
/// @cite sneed1958 @cite graham2000
struct TernaryCoordinates {
  double compact = 0.0;   ///< q = S/L
  double elongate = 0.0;  ///< (1 - q) (L - I)/(L - S)
  double platy = 0.0;     ///< (1 - q) (I - S)/(L - S)
};
TernaryCoordinates ternary_coordinates(const Axes& axes);

struct FormIndex {
  const char* name;     ///< name in tables and JSON
  const char* formula;  ///< formula in L, I and S
  const char* source;   ///< key in docs/references.bib; empty for plain ratios
  std::optional<double> (*value)(const Axes&);
};

/// Returns the definitions of all form indices, in the order of docs/theory.md.
std::span<const FormIndex> form_index_definitions();

/// Computes all form indices that are defined for the axes. Returns their values by name.
std::map<std::string, double> form_indices(const Axes& axes);

}  // namespace clast
