#pragma once
/// Terminal output of the populations of scanned deposits.
#include <string>

#include "classify/scanned_deposit.hpp"

namespace clast {

/// Formats sizes by each weighting, corrected class fractions and orientation of long axes.
std::string format_scanned_deposit(const ScannedDepositSummary& summary);
/// Returns the heading of a row of sizes: "by number", "by area", "by grid" or "by number,
/// corrected".
std::string heading_of(SizeWeighting weighting);
/// Describes which fractions of the blocks of two sizes are found, in one sentence.
std::string describe_visibility_correction(const VisibilityCorrection& correction);
/// Describes the mean trend of long axes and its test, in one sentence.
std::string describe_long_axes(const LongAxisTrends& trends);

}  // namespace clast
