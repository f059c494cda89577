#pragma once
/// Conversion of the states computed by another engine into runs.
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// States of a block at successive times, in the local frame of the terrain.
struct StateSeries {
  std::vector<double> time;        ///< times, s, ascending
  std::vector<RigidState> states;  ///< finite states at these times
};

struct RunEnding {
  StopReason reason = StopReason::kError;
  std::string message = {};  ///< message, if the run failed
};

/// Makes a run from the states that another engine computed. Motion between two states is free
/// flight if this connects them; otherwise, it is interpolated. Contact quantities are NaN, and
/// their counts are 0.
StoredRun make_run_from_states(const CampaignPlan& prepared, const RunRecord& planned,
                               const StateSeries& series, const RunEnding& end);

/// Returns the index of the first state whose centre is outside the terrain; the number of states
/// if there is none.
std::size_t find_first_state_off_terrain(const CampaignPlan& prepared, const StateSeries& series);

/// True if the block is at rest at the end of the series, according to the settings of the
/// campaign. False for a single state.
bool is_at_rest_at_end(const CampaignPlan& prepared, const RunRecord& planned,
                       const StateSeries& series);

}  // namespace clast::study_detail
