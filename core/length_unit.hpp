#pragma once
/// Units of length by name.
#include <array>
#include <string>

#include "core/number_range.hpp"

namespace clast {

/// A unit as files and options name it.
struct NamedUnit {
  const char* name;
  double factor;  ///< SI units in one
};

/// The micro sign stands twice in Unicode: as itself and as the Greek letter.
inline constexpr std::array<NamedUnit, 9> kLengthUnits = {{{"um", 1e-6},
                                                          {"\xC2\xB5m", 1e-6},
                                                          {"\xCE\xBCm", 1e-6},
                                                          {"mm", 1e-3},
                                                          {"cm", 1e-2},
                                                          {"m", 1.0},
                                                          {"km", 1e3},
                                                          {"ft", 0.3048},
                                                          {"in", 0.0254}}};

/// Metres in one unit of a scan or table.
inline constexpr NumberRange kLengthUnit{1e-12, 1e6, "m"};

/// Metres in the unit that the option `units` names: one of `kLengthUnits`, or a factor in
/// `kLengthUnit`.
/// @throws InputError  anything else
double parse_length_unit(const std::string& text);

}  // namespace clast
