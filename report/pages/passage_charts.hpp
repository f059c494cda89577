#pragma once
/// Charts and tables of simultaneous passages of persistent blocks at a barrier.
#include <string>
#include <vector>

#include "study/compare/barrier_statistics.hpp"

namespace clast::report_detail {

/// Draws cumulative blocks, mass and energy against time, with mean and range over realisations;
/// empty without passages.
std::string draw_crossing_charts(const Comparison& comparison,
                                 const std::vector<RealisationCrossings>& all, std::size_t line);

/// Describes the largest simultaneous load of a barrier; empty without passages.
std::string describe_crossings(const Comparison& comparison,
                               const std::vector<RealisationCrossings>& all, std::size_t line);

/// Formats means, minima and maxima over realisations; empty if no realisation has the barrier.
std::string format_crossing_table(const Comparison& comparison,
                                  const std::vector<RealisationCrossings>& all, std::size_t line);

}  // namespace clast::report_detail
