#pragma once
/// Barrier statistics of a comparison.
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/ground_draws.hpp"

namespace clast::study_detail {

struct BarrierComparison {
  std::vector<BarrierLine> lines;
  std::vector<BarrierCrossing> crossings;
  std::vector<BarrierGroupStatistics> groups;
};

/// Computes barrier lines, crossings and statistics.
/// @throws InputError  if a crossing refers to a run or barrier that its file does not contain
BarrierComparison compare_barriers(const std::vector<CampaignResults>& results,
                                   const std::vector<RunRow>& rows,
                                   const std::vector<RunGroup>& groups);

/// Computes the statistics of a barrier for each draw of the ground parameters. Draws without a
/// crossing are omitted.
std::vector<BarrierGroupStatistics> barrier_groups_by_draw(
    const Comparison& comparison, std::size_t line, const std::vector<GroundDrawRows>& draws);

}  // namespace clast::study_detail
