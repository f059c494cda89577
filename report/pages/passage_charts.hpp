#pragma once
/// What passes a barrier together, for the barrier section: blocks that stay come as a mass.
#include <string>
#include <vector>

#include "study/compare/barrier_passages.hpp"

namespace clast::report_detail {

/// Blocks, mass and energy that have passed against time, mean and range over realisations; empty
/// where nothing passed.
std::string draw_crossing_charts(const Comparison& comparison,
                           const std::vector<RealisationCrossings>& all, std::size_t line);

/// The most that a barrier has to take at once, in a sentence; empty where nothing passed.
std::string describe_crossings(const Comparison& comparison, const std::vector<RealisationCrossings>& all,
                          std::size_t line);

/// Means over realisations, least and most; empty where no realisation has the barrier.
std::string format_crossing_table(const Comparison& comparison, const std::vector<RealisationCrossings>& all,
                          std::size_t line);

}  // namespace clast::report_detail
