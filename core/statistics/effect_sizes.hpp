#pragma once
/// Effect sizes: how far two samples lie apart, without units.
#include <optional>
#include <span>

namespace clast {

/// Cliff's delta: the chance that a value of `a` is larger than one of `b`, less the chance that it
/// is smaller; from -1 to 1, ties count neither way.
/// @return none when either is empty
/// @cite cliff1993
std::optional<double> cliffs_delta(std::span<const double> a, std::span<const double> b);

/// "negligible", "small", "medium" or "large": the limits 0.147, 0.33 and 0.474.
/// @cite romano2006
const char* describe_cliffs_delta(double delta);

/// Hedges' g: the difference of the means in units of the pooled standard deviation, with the
/// factor 1 - 3/(4 (m + n - 2) - 1) that takes its bias away.
/// @return none below two values each, or without any spread
/// @cite hedges1981
std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b);

}  // namespace clast
