#include "study/simulate/detail/resumable_runs.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include "core/byte_archive.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/simulate/detail/checkpoint_file.hpp"
#include "study/simulate/realisation.hpp"

namespace clast::study_detail {

namespace {

/// Between two reports of a realisation under way, s.
constexpr double kReportAfter = 0.5;

/// Passes through the dynamics uncaught: a std::exception would be stored as the error of the run.
struct Stopped {
  std::exception_ptr why;
};

/// ": 12.5 s simulated, 31 of 60 blocks at rest".
std::string progress_text(const SequenceProgress& progress, const PersistentBlocksSettings& stay) {
  std::string text = ": " + format_decimals(progress.time, 1) + " s simulated";
  if (!stay.at_once) {
    return text + ", block " + std::to_string(progress.released) + " of " +
           std::to_string(stay.blocks_per_realisation);
  }
  if (progress.settling) text += ", settling";
  return text + ", " + std::to_string(progress.count_resting()) + " of " +
         format_count(progress.released, "block") + " at rest";
}

/// Checkpoints are so many times as far apart as it takes to write one, however short the interval.
constexpr double kTimesApart = 20.0;

class Timer {
 public:
  double passed() const {  ///< since it was made or restarted, s
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  void restart() { begin_ = std::chrono::steady_clock::now(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

CheckpointFile checkpoint_of(const CampaignPlan& prepared, const std::filesystem::path& target,
                             std::uint32_t first) {
  return {target, prepared.header, first / prepared.header.runs_per_realisation()};
}

}  // namespace

void ResumableRuns::check_checkpoints(const std::vector<std::uint32_t>& firsts) const {
  if (!prepared_.header.persistent_blocks || !options_.resume) return;
  for (const std::uint32_t first : firsts) checkpoint_of(prepared_, target_, first).read();
}

std::vector<StoredRun> ResumableRuns::compute(std::uint32_t first, unsigned threads,
                                              const Report& report) const {
  if (!prepared_.header.persistent_blocks)
    return simulate_realisation(prepared_, first, {}, threads);
  const CheckpointFile file = checkpoint_of(prepared_, target_, first);
  const std::string name =
      "realisation " + std::to_string(first / prepared_.header.runs_per_realisation() + 1);
  Timer report_timer, checkpoint_timer;
  double interval = options_.checkpoint_interval;
  std::string problem;  // with the last checkpoint
  const auto write = [&](const SequenceProgress& progress) {
    const Timer writing;
    problem.clear();
    try {
      file.write(progress.save_state);
    } catch (const InputError& error) {
      problem = std::string("; ") + error.what();
    }
    interval = std::max(options_.checkpoint_interval, kTimesApart * writing.passed());
    checkpoint_timer.restart();
  };
  const auto send_report = [&](const SequenceProgress& progress) {
    try {
      report(name + progress_text(progress, *prepared_.header.persistent_blocks) + problem);
    } catch (const std::exception& why) {
      write(progress);
      if (!problem.empty()) throw SimulationError(why.what() + problem);
      throw;
    }
  };
  std::string saved;
  const auto after_step = [&](const SequenceProgress& progress) {
    if (!saved.empty()) saved = std::string();  // restored by now: its memory is not needed
    if (options_.checkpoint_interval > 0.0 && checkpoint_timer.passed() >= interval) {
      write(progress);
    }
    if (!report || report_timer.passed() < kReportAfter) return;
    report_timer.restart();
    try {
      send_report(progress);
    } catch (...) {
      throw Stopped{std::current_exception()};
    }
  };
  if (options_.resume) saved = file.read().value_or("");
  ByteReader from(saved);
  try {
    return simulate_realisation(prepared_, first, after_step, threads, {},
                                saved.empty() ? nullptr : &from);
  } catch (const Stopped& stopped) {
    std::rethrow_exception(stopped.why);
  } catch (const InputError& error) {
    throw InputError(file.path().string() + ": " + error.what() +
                     "; delete it, then `resume` starts that realisation again");
  }
}

void ResumableRuns::remove_checkpoint(std::uint32_t first) const {
  if (prepared_.header.persistent_blocks) checkpoint_of(prepared_, target_, first).remove();
}

}  // namespace clast::study_detail
