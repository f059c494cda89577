#pragma once
/// Runs made from the states computed by another engine.
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// States of a block at successive times, in the local frame of the terrain.
struct StateSeries {
  std::vector<double> time;        ///< s, ascending
  std::vector<RigidState> states;  ///< finite
};

struct RunEnd {
  StopReason reason = StopReason::kError;
  std::string message = {};  ///< for errors
};

/// Makes a run from states: duration, stop position, path, barrier crossings, energies, and the
/// largest speeds of the states. Between two states the motion is the exact free flight if it
/// connects them, otherwise interpolated (`interpolate_state`). Contact quantities are NaN, counts
/// 0.
StoredRun make_run_from_states(const CampaignPlan& prepared, const RunRecord& planned,
                               const StateSeries& series, const RunEnd& end);

/// Returns the index of the first state whose centre is not above the terrain; the number of states
/// if there is none.
std::size_t find_first_off_terrain(const CampaignPlan& prepared, const StateSeries& series);

/// True if the block is at rest at the end of the series, by [run] rest_energy_j_kg and
/// rest_duration_s; false for a single state.
bool rests_at_end(const CampaignPlan& prepared, const RunRecord& planned,
                  const StateSeries& series);

}  // namespace clast::study_detail
