#pragma once
/// The barrier part of a comparison.
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/ground_draws.hpp"

namespace clast::study_detail {

struct BarrierComparison {
  std::vector<BarrierLine> lines;
  std::vector<BarrierCrossing> crossings;
  std::vector<BarrierGroupStatistics> groups;
};

/// @throws InputError  a crossing of a run or barrier that is not in its file
BarrierComparison compare_barriers(const std::vector<CampaignResults>& results,
                                   const std::vector<RunRow>& rows,
                                   const std::vector<Group>& groups);

/// What passes a barrier in each draw of the ground; draws whose runs never met it left out.
std::vector<BarrierGroupStatistics> barrier_groups_by_draw(const Comparison& comparison, std::size_t line,
                                           const std::vector<GroundDrawRows>& draws);

}  // namespace clast::study_detail
