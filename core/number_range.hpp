#pragma once
/// Allowed range of a number in files and options.
#include <string>

namespace clast {

/// Closed interval of allowed numbers, and optionally 0. Values between 0 and `low` are refused
/// even if 0 is allowed, because 1e-300 is a typing error rather than a small number.
struct NumberRange {
  double low;
  double high;
  const char* unit = "";  ///< empty: dimensionless
  const char* zero =
      nullptr;  ///< meaning of 0 if it is allowed below `low`; "" without explanation

  bool contains(double value) const;  ///< false of NaN too
  /// Formats the range as "from 0.01 to 1000 m/s^2" or "0 (none), or from 1e-06 to 100 m".
  std::string describe() const;
};

}  // namespace clast
