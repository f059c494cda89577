#pragma once
/// What outcomes do with the properties of blocks, in words.
#include <string>
#include <vector>

#include "study/campaign/planned_power.hpp"
#include "study/compare/shape_trends.hpp"

namespace clast {

/// For each outcome of each file what it rises and falls with: "Runout rises with S/L (rank
/// correlation 0.71, p < 0.001), ...; no trend with rounding." For the runout, by property, also
/// the difference between the halves of the blocks, whether it is within the margin, and what
/// difference such a campaign finds.
std::vector<std::string> describe_trends(const std::vector<ShapeTrends>& trends,
                                         const std::optional<double>& margin);

/// "a difference in runout of 2.1 m between two halves of the blocks is found in 80 % of such
/// campaigns, ...; 1 m takes 6,900 runs"; empty where nothing is known.
std::string describe_planned_power(const PlannedPower& plan);

}  // namespace clast
