#pragma once
/// The barrier part of a comparison. Internal to `compare`.
#include <vector>

#include "study/comparison.hpp"

namespace clast::study_detail {

struct BarrierComparison {
  std::vector<BarrierLine> lines;
  std::vector<CrossingRow> crossings;
  std::vector<BarrierGroup> groups;
};

/// @throws InputError  a crossing of a run or barrier that is not in its file
BarrierComparison compare_barriers(const std::vector<CampaignResults>& results,
                                   const std::vector<RunRow>& rows,
                                   const std::vector<Group>& groups);

}  // namespace clast::study_detail
