#include "study/campaign_runner.hpp"

#include <algorithm>
#include <mutex>

#include "core/parallel.hpp"
#include "study/results_journal.hpp"

namespace clast {
namespace {

// Collects what the stored results need of a motion, as it goes by.
class RunObserver {
 public:
  RunObserver(const PreparedCampaign& prepared, const RunRecord& run)
      : prepared_(prepared), body_(prepared.bodies[run.block]), run_(run.run) {}

  void see(const MotionStep& step) {
    const double gravity = prepared_.settings.gravity;
    const double interval = prepared_.campaign.trajectory_interval;
    if (interval > 0.0) {
      // Counted, not added up, so that frames of all runs fall on the same times.
      for (double time;
           (time = static_cast<double>(trajectory.time.size()) * interval) <= step.end_time;) {
        trajectory.time.push_back(time);
        trajectory.states.push_back(
            time >= step.end_time
                ? step.end
                : state_at(body_, step, std::max(time, step.begin_time), gravity));
      }
    }
    for (std::uint32_t i = 0; i < prepared_.header.barriers.size(); ++i) {
      std::optional<Crossing> crossing =
          find_crossing(prepared_.header.barriers[i], body_, step, *prepared_.surface, gravity);
      if (!crossing) continue;
      crossing->run = run_;
      crossing->barrier = i;
      crossings.push_back(*crossing);
    }
    last = step.end;
    last_time = step.end_time;
  }

  Trajectory trajectory;
  std::vector<Crossing> crossings;
  std::optional<RigidState> last;  ///< end of the last step seen
  double last_time = 0.0;

 private:
  const PreparedCampaign& prepared_;
  const RigidBody& body_;
  std::uint32_t run_;
};

StoredRun run_one(const PreparedCampaign& prepared, const RunRecord& planned) {
  StoredRun output;
  output.record = planned;
  RunObserver observer(prepared, planned);
  ReleaseResult& result = output.record.result;
  try {
    result = simulate_release(*prepared.surface, prepared.header.ground,
                              prepared.bodies[planned.block], planned.start, prepared.settings,
                              [&](const MotionStep& step) { observer.see(step); });
  } catch (const std::exception& error) {  // one bad run never costs the campaign
    result = {};
    result.stop_reason = StopReason::kError;
    result.message = error.what();
    result.duration = observer.last_time;
    result.final_state = observer.last.value_or(planned.start);
  }
  output.crossings = std::move(observer.crossings);
  std::stable_sort(output.crossings.begin(), output.crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
  output.trajectory = std::move(observer.trajectory);
  if (prepared.campaign.trajectory_interval > 0.0 &&
      (output.trajectory.time.empty() || output.trajectory.time.back() < result.duration)) {
    output.trajectory.time.push_back(result.duration);
    output.trajectory.states.push_back(result.final_state);
  }
  return output;
}

}  // namespace

void run_campaign(const PreparedCampaign& prepared, const std::filesystem::path& target,
                  const RunOptions& options) {
  const bool go_on = options.resume && std::filesystem::exists(partial_results(target));
  ResultsWriter writer = go_on ? ResultsWriter::resume(target, prepared.header)
                               : ResultsWriter::create(target, prepared.header);
  const std::vector<std::uint32_t> stored = writer.stored_runs();
  std::vector<const RunRecord*> open;
  for (const RunRecord& run : prepared.runs) {
    if (!std::binary_search(stored.begin(), stored.end(), run.run)) open.push_back(&run);
  }
  std::size_t done = stored.size();
  std::mutex one_at_a_time;
  parallel_for(open.size(), options.threads, [&](std::size_t i) {
    const StoredRun output = run_one(prepared, *open[i]);
    const std::lock_guard lock(one_at_a_time);
    writer.add(output.record, output.crossings, output.trajectory);
    ++done;
    if (options.progress) options.progress(done, prepared.runs.size());
  });
  writer.finish();
}

}  // namespace clast
