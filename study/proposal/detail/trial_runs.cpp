#include "study/proposal/detail/trial_runs.hpp"

#include <algorithm>

#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/statistics/statistics.hpp"
#include "study/simulate/realisation.hpp"

namespace clast::study_detail {
namespace {

constexpr std::size_t kTrialRuns = 16;  ///< enough to see what half of them do, within seconds
constexpr double kFewPass = 0.25;       ///< of them: a barrier there says little
constexpr double kLeastDistance = 2.0;  ///< L that blocks go at least, for a barrier to make sense

struct Trial {
  double distance = 0.0;  ///< along `downslope`, m
  bool passed = false;
  double duration = 0.0;  ///< s
  bool moving = false;    ///< still, when its time was up
};

Trial try_run(const PreparedCampaign& prepared, std::size_t run, const Vec2& downslope) {
  const StoredRun stored = runs_from(prepared, static_cast<std::uint32_t>(run)).front();
  const Vec3 way = stored.record.result.final_state.position - stored.record.start.position;
  const ReleaseResult& result = stored.record.result;
  return {way.head<2>().dot(downslope), !stored.crossings.empty(), result.duration,
          result.stop_reason == StopReason::kMaxTime};
}

std::string doubt_of(const TrialRuns& trial, const ProposedPlaces& places) {
  const std::string passed = std::to_string(trial.passed) + " of " +
                             counted(trial.count, "trial run") +
                             (trial.passed == 1 ? " passes" : " pass") + " the foot of the slope";
  if (trial.moved_barrier) {
    return passed + "; the barrier lies " + with_decimals(places.distance, 0) +
           " m from the releases, where half of them have passed";
  }
  const std::string half = ", and half of them go less than " +
                           with_decimals(std::max(trial.median_distance, 0.0), 1) + " m";
  if (trial.median_distance < places.distance) {
    return passed + half + ": with these ground parameters blocks stop near where they land";
  }
  return passed + ": the others go as far beside the barrier; look at the map of the dry run";
}

}  // namespace

void run_trials(const PreparedCampaign& prepared, CampaignProposal& proposal) {
  TrialRuns& trial = proposal.trial = {};
  trial.count = std::min(kTrialRuns, prepared.runs.size());
  std::vector<Trial> trials(trial.count);
  parallel_for(trial.count, 0, [&](std::size_t i) {
    trials[i] =
        try_run(prepared, i * prepared.runs.size() / trial.count, proposal.places.downslope);
  });
  std::vector<double> distances;
  for (const Trial& run : trials) {
    distances.push_back(run.distance);
    trial.passed += run.passed ? 1 : 0;
    trial.moving += run.moving ? 1 : 0;
    trial.longest = std::max(trial.longest, run.duration);
  }
  trial.median_distance = summarise(distances).median;
}

void judge_trials(const PreparedCampaign& prepared, CampaignProposal& proposal) {
  TrialRuns& trial = proposal.trial;
  if (trial.moving > 0) {
    proposal.doubts.push_back(std::to_string(trial.moving) + " of " +
                              counted(trial.count, "trial run") + " still move after " +
                              with_decimals(proposal.max_time, 0) +
                              " s; runs stopped by max_time_s are left out of the deposit");
  }
  if (static_cast<double>(trial.passed) >= kFewPass * static_cast<double>(trial.count)) return;
  ProposedPlaces& places = proposal.places;
  trial.moved_barrier = trial.median_distance > kLeastDistance * places.block_length &&
                        trial.median_distance < places.distance;
  if (trial.moved_barrier) {
    place_barrier(prepared.header.terrain, trial.median_distance, places);
    places.barrier_name = "halfway";
  }
  proposal.doubts.push_back(doubt_of(trial, places));
}

}  // namespace clast::study_detail
