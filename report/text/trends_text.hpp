#pragma once
/// Texts of shape trends.
#include <string>
#include <vector>

#include "study/campaign/planned_power.hpp"
#include "study/compare/shape_trends.hpp"

namespace clast {

/// Describes the trends of each outcome and file, such as "Runout rises with S/L (rank correlation
/// 0.71, p < 0.001), ...; no trend with rounding." For the runout, the text also states the
/// difference between the halves of the blocks, its equivalence within the margin, and the
/// detectable difference.
std::vector<std::string> describe_trends(const std::vector<ShapeTrends>& trends,
                                         const std::optional<double>& margin);

/// Describes the planned power, such as "a difference in runout of 2.1 m between two halves of the
/// blocks is found in 80 % of such campaigns, ...; 1 m takes 6,900 runs". Empty if unknown.
std::string describe_planned_power(const PlannedPower& plan);

}  // namespace clast
