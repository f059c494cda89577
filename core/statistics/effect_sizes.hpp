#pragma once
/// Dimensionless effect sizes of two samples.
#include <optional>
#include <span>

namespace clast {

/// Returns Cliff's delta, P(a > b) - P(a < b), which is between -1 and 1.
/// @return delta; empty if a sample is empty
/// @cite cliff1993
std::optional<double> cliffs_delta(std::span<const double> a, std::span<const double> b);

/// Classifies Cliff's delta at 0.147, 0.33 and 0.474: "negligible", "small", "medium" or "large".
/// @cite romano2006
const char* describe_cliffs_delta(double delta);

/// Returns Hedges' g: the difference of means divided by the pooled standard deviation, times the
/// bias correction 1 - 3/(4 (m + n - 2) - 1) for sample sizes m and n.
/// @return g; empty if a sample has fewer than two values, or if there is no scatter
/// @cite hedges1981
std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b);

}  // namespace clast
