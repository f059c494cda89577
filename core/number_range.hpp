#pragma once
/// Allowed range of a number in files and options.
#include <string>

namespace clast {

/// Closed interval of allowed numbers. Optionally, 0 is allowed too. Values between 0 and `low` are
/// refused even then, because such a value is probably a typing error.
struct NumberRange {
  double low;
  double high;
  const char* unit = "";  ///< empty for dimensionless numbers
  const char* zero_meaning =
      nullptr;  ///< meaning of 0 if it is allowed below `low`; "" without explanation

  bool contains(double value) const;  ///< false for NaN
  /// Formats the range as "from 0.01 to 1000 m/s^2" or "0 (none), or from 1e-06 to 100 m".
  std::string describe() const;
};

}  // namespace clast
