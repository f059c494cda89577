#pragma once
/// Runs that another engine computed, from the states that it wrote.
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// A block at successive times, in the local frame of the terrain.
struct StateSeries {
  std::vector<double> time;        ///< s, increasing
  std::vector<RigidState> states;  ///< finite
};

/// How a series ended.
struct RunEnd {
  StopReason reason = StopReason::kError;
  std::string message = {};  ///< of an error
};

/// What states tell of a run: duration, place of the end, path, crossings of the barriers, and
/// energies; speeds and spins are the largest of the states. Between two states the motion is the
/// exact flight where one leads to the other, else interpolated (`interpolate_state`). What needs contacts
/// is not a number, or 0 where it is a count: `CampaignHeader::engine` says that it is not known.
/// The trajectory is the series.
StoredRun make_run_from_states(const CampaignPlan& prepared, const RunRecord& planned,
                        const StateSeries& series, const RunEnd& end);

/// Number of the first state whose centre is not over the ground; the number of states where all
/// are.
std::size_t find_first_off_terrain(const CampaignPlan& prepared, const StateSeries& series);

/// Is the block at rest, as [run] rest_energy_j_kg and rest_duration_s say, at the end of the
/// series? One state alone can't tell.
bool rests_at_end(const CampaignPlan& prepared, const RunRecord& planned,
                  const StateSeries& series);

}  // namespace clast::study_detail
