#include "study/campaign_runner.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "study/detail/results_journal.hpp"

namespace clast {

using namespace study_detail;
namespace {

// Collects what the stored results need of a motion, as it goes by.
class RunObserver {
 public:
  RunObserver(const PreparedCampaign& prepared, const RunRecord& run)
      : impacts(prepared.bodies[run.block], run.run),
        prepared_(prepared),
        body_(prepared.bodies[run.block]),
        run_(run.run) {}

  void see(const MotionStep& step) {
    const double gravity = prepared_.campaign.gravity;
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
      for (Crossing& crossing :
           find_crossings(prepared_.header.barriers[i], body_, step, *prepared_.surface, gravity)) {
        crossing.run = run_;
        crossing.barrier = i;
        crossings.push_back(crossing);
      }
    }
    impacts.see(step);
    last = step.end;
    last_time = step.end_time;
  }

  Trajectory trajectory;
  std::vector<Crossing> crossings;
  ImpactObserver impacts;
  std::optional<RigidState> last;  ///< end of the last step seen
  double last_time = 0.0;

 private:
  const PreparedCampaign& prepared_;
  const RigidBody& body_;
  std::uint32_t run_;
};

// Thrown by a probe that is long enough; no error of the run.
struct ProbeOver {};

/// @param after_step  called with the simulated time after every step and flight
StoredRun run_one(const PreparedCampaign& prepared, const RunRecord& planned,
                  const std::function<void(double)>& after_step = {}) {
  StoredRun output;
  output.record = planned;
  RunObserver observer(prepared, planned);
  ReleaseResult& result = output.record.result;
  try {
    result =
        simulate_release(*prepared.surface, prepared.header.ground_sets[planned.ground_set].zones,
                         prepared.bodies[planned.block], planned.start,
                         release_settings(prepared.campaign, planned), [&](const MotionStep& step) {
                           observer.see(step);
                           if (after_step) after_step(step.end_time);
                         });
  } catch (const std::exception& error) {  // one bad run never costs the campaign
    result = {};
    result.stop_reason = StopReason::kError;
    result.message = error.what();
    result.duration = observer.last_time;
    result.final_state = observer.last.value_or(planned.start);
  }
  observer.impacts.finish();
  output.record.contacts = observer.impacts.statistics;
  output.impacts = std::move(observer.impacts.impacts);
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

// Keeps finished runs, one at a time, and reports progress.
class Collector {
 public:
  Collector(ResultsWriter& writer, std::size_t planned, const RunOptions& options)
      : writer_(writer), done_(writer.stored_runs().size()), planned_(planned), options_(options) {}

  void add(const StoredRun& run) {
    const std::lock_guard lock(one_at_a_time_);
    writer_.add(run);
    ++done_;
    if (options_.progress) options_.progress({.done = done_, .total = planned_});
  }

 private:
  ResultsWriter& writer_;
  std::size_t done_;
  std::size_t planned_;
  const RunOptions& options_;
  std::mutex one_at_a_time_;
};

// The processes that do not lead: runs as they are handed out, until there are none.
void follow(const PreparedCampaign& prepared, unsigned threads, ProcessTeam& team) {
  std::mutex one_at_a_time;
  parallel_for(threads, threads, [&](std::size_t) {
    std::string done;
    while (true) {
      std::optional<std::size_t> next;
      {
        const std::lock_guard lock(one_at_a_time);
        next = team.exchange(done);
      }
      if (!next) return;
      done = packed(run_one(prepared, prepared.runs[*next]));
    }
  });
}

// The process that leads: its own threads compute beside the other processes, its first one waits
// for what they hand in. MPI can't sleep until something comes without burning a core, so it looks
// this often. What ends the campaign early is returned once every process knows of it.
constexpr std::chrono::microseconds kLookAround(500);

std::exception_ptr lead(const PreparedCampaign& prepared, const std::vector<std::uint32_t>& open,
                        unsigned threads, ProcessTeam& team, Collector& collector) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::mutex failure_mutex;
  std::exception_ptr failure;
  const auto guarded = [&](const std::function<void()>& action) {
    try {
      action();
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
  };
  const auto take = [&]() -> std::optional<std::size_t> {
    if (stop) return std::nullopt;
    const std::size_t item = next++;
    return item < open.size() ? std::optional<std::size_t>(open[item]) : std::nullopt;
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < threads; ++i) {
    workers.emplace_back([&] {
      while (const std::optional<std::size_t> run = take()) {
        guarded([&] { collector.add(run_one(prepared, prepared.runs[*run])); });
      }
    });
  }
  for (std::size_t waiting = std::size_t{team.size() - 1} * threads; waiting > 0;) {
    const std::optional<ProcessTeam::Delivery> delivery = team.delivery();
    if (!delivery) {
      std::this_thread::sleep_for(kLookAround);
      continue;
    }
    if (!delivery->done.empty()) guarded([&] { collector.add(unpacked(delivery->done)); });
    const std::optional<std::size_t> run = take();
    team.answer(delivery->from, run);
    if (!run) --waiting;
  }
  workers.clear();
  return failure;
}

// Runs of the shard that are not stored yet.
std::vector<std::uint32_t> open_runs(const PreparedCampaign& prepared, const Shard& shard,
                                     const std::filesystem::path& target,
                                     const std::vector<std::uint32_t>& stored) {
  for (const std::uint32_t run : stored) {
    if (shard.has(run)) continue;
    throw InputError(partial_results(target).string() + ": was begun with other runs than shard " +
                     std::to_string(shard.index) + " of " + std::to_string(shard.count) +
                     " has; give the shard it was begun with, or delete it");
  }
  std::vector<std::uint32_t> open;
  for (const RunRecord& run : prepared.runs) {
    if (shard.has(run.run) && !std::binary_search(stored.begin(), stored.end(), run.run)) {
      open.push_back(run.run);
    }
  }
  return open;
}

}  // namespace

ReleaseSettings release_settings(const Campaign& campaign, const RunRecord& run) {
  return {.stiffness = run.stiffness,
          .law = campaign.stiffness.law,
          .weights = campaign.weights,
          .gravity = campaign.gravity,
          .max_time = campaign.max_time,
          .rest_energy = campaign.rest_energy,
          .rest_duration = campaign.rest_duration};
}

TimeProbe probe_time(const PreparedCampaign& prepared, double budget) {
  // Steps of the golden ratio are spread evenly however many are taken.
  constexpr double kGoldenRatio = 0.61803398874989485;
  // A run that takes this many times the budget is not waited for.
  constexpr double kLongestProbe = 5.0;
  const double count = static_cast<double>(prepared.runs.size());
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  TimeProbe probe;
  double whole = 0.0;  // time of the runs that were not cut short
  // Simulated time, s, and what it took, of the run that goes on, halfway to its end and now.
  double halfway = -1.0, halfway_spent = 0.0, reached = 0.0;
  const auto in_time = [&](double time) {
    const double now = spent() - whole, longest = kLongestProbe * budget - whole;
    reached = time;
    if (halfway < 0.0 && now > 0.5 * longest) {
      halfway = time;
      halfway_spent = now;
    }
    if (now > longest) throw ProbeOver();
  };
  try {
    while (probe.runs < prepared.runs.size() && (probe.runs == 0 || whole < budget)) {
      const double share = std::fmod(0.5 + static_cast<double>(probe.runs) * kGoldenRatio, 1.0);
      run_one(prepared, prepared.runs[static_cast<std::size_t>(share * count)], in_time);
      ++probe.runs;
      whole = spent();
      halfway = -1.0;
    }
  } catch (const ProbeOver&) {
    // Flights cost next to nothing: the second half, as a rule without one, shows what is to come.
    probe.cut_short = true;
    const double taken = spent() - whole;
    const double pace = (taken - halfway_spent) / std::max(reached - halfway, 1e-12);
    whole += taken + pace * (prepared.campaign.max_time - reached);
    ++probe.runs;
  }
  if (probe.runs > 0) probe.each = whole / static_cast<double>(probe.runs);
  return probe;
}

void Shard::check() const {
  if (count == 0 || index == 0 || index > count) {
    throw InputError("shard " + std::to_string(index) + "/" + std::to_string(count) +
                     ": must be from 1/n to n/n");
  }
}

void run_campaign(const PreparedCampaign& prepared, const std::filesystem::path& target,
                  const RunOptions& options) {
  options.shard.check();
  const std::size_t runs = options.shard.runs_of(prepared.runs.size());
  if (options.resume && !options.replace && !std::filesystem::exists(partial_results(target)) &&
      is_finished(target, prepared.header, runs)) {
    return;
  }
  ProcessTeam* team = options.team && options.team->size() > 1 ? options.team : nullptr;
  // Processes are asked for one by one, so each has a core to itself unless another number is
  // given.
  const unsigned threads = options.threads == 0 && team ? 1 : thread_count(options.threads);
  std::optional<ResultsWriter> writer;
  std::vector<std::uint32_t> open;
  const auto open_results = [&] {
    if (team && !team->leads()) return std::string();
    const bool go_on = options.resume && std::filesystem::exists(partial_results(target));
    if (!go_on) check_results_place(target, options.replace);
    writer.emplace(go_on ? ResultsWriter::resume(target, prepared.header, runs)
                         : ResultsWriter::create(target, prepared.header, runs));
    open = open_runs(prepared, options.shard, target, writer->stored_runs());
    return std::string();
  };
  if (!team) {
    open_results();
    Collector collector(*writer, open.size() + writer->stored_runs().size(), options);
    parallel_for(open.size(), threads,
                 [&](std::size_t i) { collector.add(run_one(prepared, prepared.runs[open[i]])); });
    writer->finish();
    return;
  }
  team->agree(open_results);
  team->begin();
  std::exception_ptr failure;
  if (team->leads()) {
    Collector collector(*writer, open.size() + writer->stored_runs().size(), options);
    failure = lead(prepared, open, threads, *team, collector);
  } else {
    follow(prepared, threads, *team);
  }
  team->end();
  if (failure) std::rethrow_exception(failure);
  if (writer) writer->finish();
}

}  // namespace clast
