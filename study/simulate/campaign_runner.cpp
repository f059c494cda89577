#include "study/simulate/campaign_runner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <mutex>
#include <optional>

#include "core/error.hpp"
#include "core/machine.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/statistics/statistics.hpp"
#include "study/results/results_journal.hpp"
#include "study/results/runout.hpp"
#include "study/simulate/detail/checkpoint_file.hpp"
#include "study/simulate/detail/probed_time.hpp"
#include "study/simulate/detail/resumable_runs.hpp"
#include "study/simulate/memory_need.hpp"
#include "study/simulate/realisation.hpp"
#include "study/simulate/team_work.hpp"

namespace clast {

using namespace study_detail;
namespace {

// Thrown by a probe that is long enough; no error of the run.
struct ProbeOver {};

// Keeps finished runs, one at a time, and reports progress.
class Collector {
 public:
  Collector(ResultsWriter& writer, std::size_t planned, const CampaignRunOptions& options)
      : writer_(writer),
        before_(writer.completed_runs()),
        done_(before_.size()),
        planned_(planned),
        options_(options) {}

  /// Runs and keeps those that are computed together from `first` on.
  /// @param threads  that a realisation may use
  void compute(const ResumableRuns& runs, std::uint32_t first, unsigned threads = 1) {
    add(runs.compute(first, threads, [this](const std::string& what) {
      const std::lock_guard lock(one_at_a_time_);
      report_progress(what);
    }));
    runs.remove_checkpoint(first);
  }

  /// Some runs of a group may have been stored before an interruption.
  void add(const std::vector<StoredRun>& runs) {
    const std::lock_guard lock(one_at_a_time_);
    for (const StoredRun& run : runs) {
      if (std::binary_search(before_.begin(), before_.end(), run.record.run)) continue;
      writer_.add(run);
      ++done_;
    }
    report_progress();
  }

 private:
  void report_progress(const std::string& what = "") const {
    if (!options_.progress) return;
    options_.progress(
        {.done = done_, .total = planned_, .done_before = before_.size(), .activity = what});
  }

  ResultsWriter& writer_;
  std::vector<std::uint32_t> before_;  ///< runs that were there already
  std::size_t done_;
  std::size_t planned_;
  const CampaignRunOptions& options_;
  std::mutex one_at_a_time_;
};

// Packs runs that were computed together, for exchange between processes.
std::string packed_together(const std::vector<StoredRun>& runs) {
  std::string bytes;
  for (const StoredRun& run : runs) {
    const std::string one = serialize_stored_run(run);
    const std::uint64_t length = one.size();
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes += one;
  }
  return bytes;
}

std::vector<StoredRun> unpacked_together(const std::string& bytes) {
  std::vector<StoredRun> runs;
  for (std::size_t at = 0; at < bytes.size();) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data() + at, sizeof length);
    at += sizeof length;
    runs.push_back(deserialize_stored_run(bytes.substr(at, length)));
    at += length;
  }
  return runs;
}

// The first runs of those that are computed together, of the shard, and not all stored yet.
std::vector<std::uint32_t> open_runs(const CampaignPlan& prepared, const Shard& shard,
                                     const std::filesystem::path& target,
                                     const std::vector<std::uint32_t>& stored) {
  const std::uint32_t together = prepared.header.runs_per_realisation();
  for (const std::uint32_t run : stored) {
    if (shard.contains(run / together)) continue;
    throw InputError(results_journal_path(target).string() +
                     ": was begun with other runs than shard " + std::to_string(shard.index) +
                     " of " + std::to_string(shard.count) +
                     " has; give the shard with which it was begun, or delete it");
  }
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < prepared.runs.size(); first += together) {
    if (!shard.contains(first / together)) continue;
    const auto begin = std::lower_bound(stored.begin(), stored.end(), first);
    const auto end = std::lower_bound(begin, stored.end(), first + together);
    if (end - begin < static_cast<std::ptrdiff_t>(together)) open.push_back(first);
  }
  return open;
}

}  // namespace

MotionSettings motion_settings(const Campaign& campaign, const RunRecord& run) {
  return {.stiffness = run.stiffness,
          .law = campaign.stiffness.law,
          .weighting = campaign.weighting,
          .gravity = campaign.gravity,
          .rest_energy = campaign.rest_energy,
          .rest_duration = campaign.rest_duration};
}

ReleaseSettings release_settings(const Campaign& campaign, const RunRecord& run) {
  return {motion_settings(campaign, run), campaign.max_time};
}

namespace {

double probed_runout(const CampaignPlan& prepared, const StoredRun& run) {
  const Vec3& start = run.record.start.position;
  const Vec3& stop = run.record.result.final_state.position;
  if (!prepared.campaign.downslope) return (stop - start).head<2>().norm();
  return compute_runout(start, stop, prepared.campaign.downslope->normalized()).along;
}

}  // namespace

RunTimeProbe measure_run_time(const CampaignPlan& prepared, double budget) {
  check_free_memory(prepared, 1, available_memory());
  // Single releases of the blocks of a realisation, 1/16 apart in the fraction that still moves.
  constexpr std::size_t kMaxSingleReleases = 16;
  // A run that takes this many times the budget is not waited for.
  constexpr double kMaxProbe = 5.0;
  const std::uint32_t together = prepared.header.runs_per_realisation();
  const bool at_once =
      prepared.header.persistent_blocks && prepared.header.persistent_blocks->at_once;
  const double max_time = prepared.campaign.max_time;
  const double longest_run =  // s, simulated
      at_once ? prepared.campaign.persistent_blocks->settling_time() +
                    prepared.campaign.persistent_blocks->last_release_time() + max_time
              : together * max_time;
  // The probe is as long as its user waits; its result is processor time, so that other programs
  // do not change it.
  const auto begin = std::chrono::steady_clock::now();
  const auto waited = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const double computed_before = thread_processor_time();
  const auto computed = [&] { return thread_processor_time() - computed_before; };
  RunTimeProbe probe;
  double whole = 0.0;             // computing time of the runs that were not cut short
  double waited_for_whole = 0.0;  // waited for these
  std::uint32_t current = 0;      // first run of the current realisation
  // The current run halfway to the end of the probe and at its end.
  std::optional<ProbedState> halfway;
  ProbedState reached;
  double first_release = 0.0;
  std::size_t released = 1;
  const auto in_time = [&](const SequenceProgress& progress) {
    const double longest = kMaxProbe * budget - waited_for_whole;
    const double waiting = waited() - waited_for_whole;
    const bool is_over = waiting > longest;
    if (progress.settling) first_release = progress.time;
    if (!is_over && (halfway || waiting <= 0.5 * longest)) return;
    released = progress.released;
    reached = {progress.time, computed() - whole, progress.settling ? together : released};
    if (progress.count_resting && !progress.settling) {
      reached.finished = progress.count_resting();
      reached.moving -= reached.finished;
    }
    if (is_over) throw ProbeOver();
    halfway = reached;
  };
  try {
    while (probe.runs < prepared.runs.size() && (probe.runs == 0 || waited_for_whole < budget)) {
      const double share = evenly_spread_fraction(probe.runs);
      const auto items = static_cast<double>(prepared.runs.size() / together);
      current = together * static_cast<std::uint32_t>(share * items);
      first_release = 0.0;
      const std::vector<StoredRun> tried = simulate_realisation(prepared, current, in_time);
      for (const StoredRun& run : tried) {
        probe.runouts.push_back(probed_runout(prepared, run));
        const ReleaseResult& result = run.record.result;
        if (probe.first_failure.empty() && result.stop_reason == StopReason::kError) {
          probe.first_failure = result.message;
        }
      }
      probe.runs += together;
      whole = computed();
      waited_for_whole = waited();
      halfway.reset();
    }
  } catch (const ProbeOver&) {
    probe.last_run_stopped = true;
    const double taken = computed() - whole;
    if (!at_once && released > 1) {
      // If blocks are released in sequence, the others take as long as those at rest.
      whole += taken * static_cast<double>(together) / static_cast<double>(released - 1);
    } else {
      std::vector<MotionInterval> single;
      if (at_once) single = release_blocks_singly(prepared, current, kMaxSingleReleases, budget);
      probe.is_upper_bound = single.empty();
      if (single.empty()) single.push_back({0.0, longest_run - first_release});
      // Flights cost little, so the second half, usually without one, shows the remaining cost.
      const ProbedState half = halfway.value_or(ProbedState{.moving = reached.moving});
      whole += taken + estimate_remaining_time(half, reached, first_release, at_once ? together : 1,
                                               single);
    }
    probe.runs += together;
  }
  if (probe.runs > 0) probe.time_per_run = whole / static_cast<double>(probe.runs);
  return probe;
}

PlannedPower compute_planned_power(const CampaignPlan& prepared, const RunTimeProbe& probe) {
  if (prepared.header.persistent_blocks) return {};
  return {prepared.runs.size(), prepared.bodies.size(), probe.runouts.size(),
          summarise_sample(probe.runouts).std, std::nullopt};
}

double estimate_time(const CampaignPlan& prepared, const RunTimeProbe& probe, const Shard& shard,
                     unsigned threads) {
  // Realisations are computed one by one.
  const std::size_t together = prepared.header.runs_per_realisation();
  const std::size_t items = shard.run_count(prepared) / together;
  return probe.time_per_run * static_cast<double>(together) * static_cast<double>(items) /
         static_cast<double>(std::clamp<std::size_t>(items, 1, threads));
}

std::size_t Shard::run_count(const CampaignPlan& prepared) const {
  const std::uint32_t together = prepared.header.runs_per_realisation();
  const std::size_t items = prepared.runs.size() / together;
  return (items / count + (items % count >= index ? 1 : 0)) * together;
}

void Shard::check() const {
  if (count == 0 || index == 0 || index > count) {
    throw InputError("shard " + std::to_string(index) + "/" + std::to_string(count) +
                     ": must be from 1/n to n/n");
  }
}

void run_campaign(const CampaignPlan& prepared, const std::filesystem::path& target,
                  const CampaignRunOptions& options) {
  options.shard.check();
  if (!(options.checkpoint_interval >= 0.0)) {
    throw InputError("checkpoint_interval = " + format_significant(options.checkpoint_interval, 6) +
                     " s; must be 0 or more");
  }
  const std::size_t runs = options.shard.run_count(prepared);
  if (options.resume && !options.replace &&
      !std::filesystem::exists(results_journal_path(target)) &&
      has_finished_results(target, prepared.header, runs)) {
    return;
  }
  ProcessTeam* team = options.team && options.team->size() > 1 ? options.team : nullptr;
  // Processes are started one by one, so each uses one core unless another number is given.
  const unsigned threads = options.threads == 0 && team ? 1 : resolve_thread_count(options.threads);
  check_free_memory(
      prepared, std::clamp<std::size_t>(runs / prepared.header.runs_per_realisation(), 1, threads),
      available_memory());
  const ResumableRuns resumable(prepared, target, options);
  std::optional<ResultsWriter> writer;
  std::vector<std::uint32_t> open;
  const auto open_results = [&] {
    if (team && !team->is_leader()) return std::string();
    const bool go_on = options.resume && std::filesystem::exists(results_journal_path(target));
    if (!go_on) check_results_target(target, options.replace);
    writer.emplace(go_on ? ResultsWriter::resume(target, prepared.header, runs)
                         : ResultsWriter::create(target, prepared.header, runs));
    open = open_runs(prepared, options.shard, target, writer->completed_runs());
    if (!options.resume) CheckpointFile::remove_all(target);
    resumable.check_checkpoints(open);
    return std::string();
  };
  if (!team) {
    open_results();
    Collector collector(*writer, runs, options);
    // Fewer realisations than threads share these.
    const auto each = static_cast<unsigned>(
        std::max<std::size_t>(1, threads / std::max<std::size_t>(1, open.size())));
    parallel_for(open.size(), threads,
                 [&](std::size_t i) { collector.compute(resumable, open[i], each); });
    CheckpointFile::remove_all(target);
    writer->finish();
    return;
  }
  team->check_agreement(open_results);
  if (team->is_leader()) {
    Collector collector(*writer, runs, options);
    distribute_work(
        *team, open, threads, [&](std::uint32_t run) { collector.compute(resumable, run); },
        [&](const std::string& done) {
          const std::vector<StoredRun> runs_done = unpacked_together(done);
          collector.add(runs_done);
          resumable.remove_checkpoint(runs_done.front().record.run);
        });
    CheckpointFile::remove_all(target);
    writer->finish();
  } else {
    process_received_work(*team, threads, [&](std::uint32_t run) {
      return packed_together(resumable.compute(run, 1));
    });
  }
}

}  // namespace clast
