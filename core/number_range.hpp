#pragma once
/// The allowed range of a number from a file or an option.
#include <string>

namespace clast {

/// Both ends belong to the range. Values between 0 and `low` are refused also where 0 itself is
/// allowed: 1e-300 is a typing error, not a small number.
struct NumberRange {
  double low;
  double high;
  const char* unit = "";       ///< empty: a pure number
  const char* zero = nullptr;  ///< what 0 means where it is allowed below `low`; "" says no more

  bool contains(double value) const;  ///< false of NaN too
  /// "from 0.01 to 1000 m/s^2", "0 (none), or from 1e-06 to 100 m".
  std::string describe() const;
};

}  // namespace clast
