#pragma once
/// Dimensionless effect sizes of two samples.
#include <optional>
#include <span>

namespace clast {

/// Returns Cliff's delta: P(a > b) - P(a < b), from -1 to 1.
/// @return empty if a sample is empty
/// @cite cliff1993
std::optional<double> cliffs_delta(std::span<const double> a, std::span<const double> b);

/// Describes Cliff's delta as "negligible", "small", "medium" or "large", with limits 0.147, 0.33
/// and 0.474.
/// @cite romano2006
const char* describe_cliffs_delta(double delta);

/// Returns Hedges' g: the difference of means over the pooled standard deviation, with the bias
/// correction 1 - 3/(4 (m + n - 2) - 1).
/// @return empty below two values each, or without scatter
/// @cite hedges1981
std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b);

}  // namespace clast
