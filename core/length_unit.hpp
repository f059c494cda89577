#pragma once
/// Length units.
#include <array>
#include <string>

#include "core/number_range.hpp"

namespace clast {

/// Unit with its name in files and options, and its value.
struct NamedUnit {
  const char* name;
  double factor;  ///< value in SI units
};

/// Length units. The micro sign is listed twice, because Unicode has it also as the Greek letter.
inline constexpr std::array<NamedUnit, 9> kLengthUnits = {{{"um", 1e-6},
                                                           {"\xC2\xB5m", 1e-6},
                                                           {"\xCE\xBCm", 1e-6},
                                                           {"mm", 1e-3},
                                                           {"cm", 1e-2},
                                                           {"m", 1.0},
                                                           {"km", 1e3},
                                                           {"ft", 0.3048},
                                                           {"in", 0.0254}}};

/// Allowed range of the length unit of a scan or table, m.
inline constexpr NumberRange kLengthUnitRange{1e-12, 1e6, "m"};

/// Parses the option `units`, which is a name of `kLengthUnits` or a number of metres in
/// `kLengthUnitRange`. Returns metres per unit.
/// @throws InputError  if the text is neither
double parse_length_unit(const std::string& text);

}  // namespace clast
