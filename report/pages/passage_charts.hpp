#pragma once
/// Charts and tables of the passages of persistent blocks at a barrier against time.
#include <string>
#include <vector>

#include "study/compare/barrier_statistics.hpp"

namespace clast::report_detail {

/// Draws the cumulative number, mass and energy of passing blocks against time, with mean and range
/// over the realisations. Empty if there are no passages.
std::string draw_crossing_charts(const Comparison& comparison,
                                 const std::vector<RealisationCrossings>& all, std::size_t line);

/// Describes the largest simultaneous load of a barrier. Empty if there are no passages.
std::string describe_crossings(const Comparison& comparison,
                               const std::vector<RealisationCrossings>& all, std::size_t line);

/// Formats means, minima and maxima over the realisations. Empty if no realisation has the barrier.
std::string format_crossing_table(const Comparison& comparison,
                                  const std::vector<RealisationCrossings>& all, std::size_t line);

}  // namespace clast::report_detail
