#pragma once
/// Texts of shape trends.
#include <string>
#include <vector>

#include "study/campaign/planned_power.hpp"
#include "study/compare/shape_trends.hpp"

namespace clast {

/// Describes the trends of outcomes with block properties, such as "Runout rises with S/L (rank
/// correlation 0.71, p < 0.001), ...; no trend with rounding."
std::vector<std::string> describe_trends(const std::vector<ShapeTrends>& trends,
                                         const std::optional<double>& margin);

/// Describes the planned statistical power of a campaign in a sentence. Empty if unknown.
std::string describe_planned_power(const PlannedPower& plan);

}  // namespace clast
