#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <streambuf>

#include "app/commands/commands.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/file_kind.hpp"
#include "core/file_lock.hpp"
#include "core/number_text.hpp"
#include "core/output_file.hpp"
#include "core/parallel.hpp"
#include "core/printable.hpp"
#include "core/text_file.hpp"
#include "core/text_table.hpp"
#include "report/maps/plan_map.hpp"
#include "study/block_stiffness.hpp"
#include "study/campaign_runner.hpp"
#include "study/comparison.hpp"

namespace clast {

namespace {

struct SimulateArgs {
  std::string campaign;
  std::string output = "results.h5";
  unsigned threads = 0;
  bool resume = false;
  bool replace = false;
  bool dry_run = false;
  bool json = false;
  std::string shard;
  std::vector<std::string> parts;
};

/// "2/4".
/// @throws CLI::ValidationError  anything else
Shard shard_from(const std::string& text) {
  Shard shard;
  if (text.empty()) return shard;
  std::istringstream words(text);
  char slash = 0;
  const bool whole = text.find_first_not_of("0123456789/") == std::string::npos &&
                     static_cast<bool>(words >> shard.index >> slash >> shard.count) &&
                     slash == '/' && words.peek() == std::istringstream::traits_type::eof();
  if (!whole) {
    throw CLI::ValidationError("--shard: \"" + text + "\" is not of the form i/n, for example 2/4");
  }
  check_usage([&] { shard.check(); });
  return shard;
}

/// "results.h5" of shard 2 of 4 is "results.2of4.h5", so that shards started with one command line
/// do not write over each other.
std::filesystem::path output_of(const SimulateArgs& args, const Shard& shard) {
  std::filesystem::path output = args.output;
  if (args.shard.empty()) return output;
  const std::string part = "." + std::to_string(shard.index) + "of" + std::to_string(shard.count);
  output.replace_filename(output.stem().string() + part + output.extension().string());
  return output;
}

nlohmann::ordered_json plan_json(const PreparedCampaign& prepared) {
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  for (const BlockSummary& block : prepared.header.blocks) blocks.push_back(block.id);
  nlohmann::ordered_json stiffness = nlohmann::ordered_json::array();
  for (const BlockStiffness& block : stiffness_by_block(prepared.header.blocks, prepared.runs)) {
    nlohmann::ordered_json row = {{"block", block.block}};
    for (const StiffnessValue& value : block.values) {
      row[value.name] = {value.range.low, value.range.high};
    }
    stiffness.push_back(row);
  }
  return {{"runs", prepared.runs.size()},
          {"blocks", blocks},
          {"release_points", prepared.header.release_points.size()},
          {"stiffness", stiffness},
          {"warnings", prepared.header.warnings}};
}

/// "4 release points, 64 orientations", for each release set, and how often the ground is drawn.
std::string releases_text(const PreparedCampaign& prepared) {
  std::string text;
  for (const ReleasePlan& release : prepared.campaign.releases) {
    text += (text.empty() ? "" : "; ") +
            (release.name.empty() ? "" : printable(release.name) + ": ") +
            counted(release.points.size(), "release point") + ", " +
            counted(release.orientations.size(), "orientation");
  }
  const std::uint32_t members = prepared.campaign.ensemble.members;
  if (members > 1) text += "; ground parameters drawn " + std::to_string(members) + " times";
  return text;
}

/// More blocks than this are not printed one by one.
constexpr std::size_t kMostPrinted = 20;

/// Stiffness and time step of the runs of each block, and over all blocks where there are many.
TextTable stiffness_table(const PreparedCampaign& prepared) {
  const std::vector<BlockStiffness> blocks =
      stiffness_by_block(prepared.header.blocks, prepared.runs);
  TextTable table{{"block"}, {}};
  for (const StiffnessValue& value : blocks.front().values) {
    table.headings.push_back(value.heading);
  }
  const auto add = [&](const BlockStiffness& block) {
    std::vector<std::string> row = stiffness_cells(block);
    row.insert(row.begin(), block.block);
    table.rows.push_back(row);
  };
  for (std::size_t i = 0; i < std::min(blocks.size(), kMostPrinted); ++i) add(blocks[i]);
  if (blocks.size() > kMostPrinted) add(over_all(blocks));
  return table;
}

void print_plan(const PreparedCampaign& prepared) {
  std::cout << counted(prepared.runs.size(), "run") << ": "
            << counted(prepared.bodies.size(), "block") << ", " << releases_text(prepared) << "\n"
            << stiffness_table(prepared).text();
  for (const std::string& warning : prepared.header.warnings) {
    std::cout << "warning: " << shown(warning) << "\n";
  }
}

constexpr std::array<StopReason, 4> kReasons = {StopReason::kRest, StopReason::kLeftTerrain,
                                                StopReason::kMaxTime, StopReason::kError};

/// What came out, over all runs.
struct Outcome {
  std::array<std::size_t, 4> reasons = {};
  std::size_t below_ground = 0;
  double largest_energy_error = 0.0;
  std::size_t reassigned = 0;  ///< runs above `kNotableReassigned`
  double largest_reassigned = 0.0;
  std::string first_error;

  std::size_t errors() const { return reasons.back(); }  ///< `kReasons` ends with them
};

Outcome outcome_of(const CampaignResults& results) {
  Outcome outcome;
  for (const RunRecord& run : results.runs) {
    const auto reason = std::find(kReasons.begin(), kReasons.end(), run.result.stop_reason);
    ++outcome.reasons[static_cast<std::size_t>(reason - kReasons.begin())];
    if (run.result.below_ground) ++outcome.below_ground;
    outcome.largest_energy_error = std::max(outcome.largest_energy_error, run.result.energy.error);
    const double reassigned = reassigned_share(run.result.energy).value_or(0.0);
    if (reassigned > kNotableReassigned) ++outcome.reassigned;
    outcome.largest_reassigned = std::max(outcome.largest_reassigned, reassigned);
    if (run.result.stop_reason == StopReason::kError && outcome.first_error.empty()) {
      outcome.first_error = "run " + std::to_string(run.run) + ": " + run.result.message;
    }
  }
  return outcome;
}

void print_outcome(const CampaignResults& results) {
  const Outcome outcome = outcome_of(results);
  TextTable table{{"stop reason", "runs"}, {}};
  for (std::size_t i = 0; i < kReasons.size(); ++i) {
    table.rows.push_back({name_of(kReasons[i]), std::to_string(outcome.reasons[i])});
  }
  std::cout << table.text() << outcome.below_ground << " runs ended below ground, "
            << results.crossings.size() << " barrier crossings, largest energy error "
            << rounded(outcome.largest_energy_error, 2) << "\n";
  if (outcome.reassigned > 0) {
    std::cout
        << "warning: " << counted(outcome.reassigned, "run")
        << " lose or gain more than 10 % of the energy they dissipate where contacts change, at "
           "most "
        << rounded(100.0 * outcome.largest_reassigned, 2)
        << " %; clast compare says which and what to try\n";
  }
}

/// All runs are kept, but a campaign with failed ones has failed.
/// @throws SimulationError  any run ended with an error
void check_outcome(const CampaignResults& results, const std::filesystem::path& file) {
  const Outcome outcome = outcome_of(results);
  if (outcome.errors() == 0) return;
  throw SimulationError(
      std::to_string(outcome.errors()) + " of " + counted(results.runs.size(), "run") +
      " ended with an error, the first: " + outcome.first_error + ". All runs are in " +
      file.string() +
      "; clast compare lists the failed ones and leaves them out of its statistics. Try a "
      "smaller "
      "[contact] time_step_s, or stiffness = \"auto\", and look at the ground at the place named");
}

nlohmann::ordered_json outcome_json(const CampaignResults& results) {
  const Outcome outcome = outcome_of(results);
  nlohmann::ordered_json reasons;
  for (std::size_t i = 0; i < kReasons.size(); ++i) {
    reasons[name_of(kReasons[i])] = outcome.reasons[i];
  }
  return {{"stop_reasons", reasons},
          {"below_ground", outcome.below_ground},
          {"crossings", results.crossings.size()},
          {"largest_energy_error", outcome.largest_energy_error},
          {"largest_reassigned_share", outcome.largest_reassigned}};
}

/// @param done  what became of the file
void print_results(const std::filesystem::path& file, const SimulateArgs& args,
                   nlohmann::ordered_json summary, const std::string& done = "written") {
  const CampaignResults results = read_results(file);
  if (args.json) {
    summary.update(outcome_json(results));
    std::cout << summary.dump(2) << "\n";
  } else {
    print_outcome(results);
    std::cout << printable(file.string()) << ": " << done << "\n";
  }
  check_outcome(results, file);
}

void join_parts(const SimulateArgs& args) {
  const std::filesystem::path target = args.output;
  check_results_place(target, args.replace);
  merge_results({args.parts.begin(), args.parts.end()}, target);
  print_results(target, args, nlohmann::ordered_json::object());
}

/// Only the process that leads speaks; what others have to say reaches it through `agree`.
void silence() {
  // Streams that swallow everything stay good, unlike closed ones, which main calls a failure.
  struct Swallow : std::streambuf {
    int overflow(int character) override { return traits_type::not_eof(character); }
  };
  // Never destroyed: the streams are flushed after everything else.
  static Swallow& swallow = *new Swallow;
  std::cout.rdbuf(&swallow);
  std::cerr.rdbuf(&swallow);
}

constexpr double kProbeTime = 2.0;  ///< s that a dry run spends on runs

/// Expected time, and the map.
void report_dry_run(const SimulateArgs& args, const PreparedCampaign& prepared, const Shard& shard,
                    nlohmann::ordered_json summary) {
  std::filesystem::path map = args.output;
  map.replace_extension(".map.svg");
  const OutputRules rules = check_output(map, {.kind = kind_by_name(map)});
  const TimeProbe probe = probe_time(prepared, kProbeTime);
  const unsigned threads = thread_count(args.threads);
  const std::size_t runs = shard.runs_of(prepared.runs.size());
  const double expected = probe.each * static_cast<double>(runs) / threads;
  write_output(map, plan_map(prepared.header), rules);
  if (args.json) {
    summary["expected_time_s"] = expected;
    summary["probed_runs"] = probe.runs;
    summary["probe_cut_short"] = probe.cut_short;
    summary["threads"] = threads;
    summary["map"] = map.string();
    std::cout << summary.dump(2) << "\n";
    return;
  }
  std::cout << (probe.cut_short ? "at most " : "about ") << duration_text(expected) << " for "
            << counted(runs, "run") << " on " << counted(threads, "thread") << ", judging by "
            << counted(probe.runs, "run") << " of " << rounded(probe.each, 2) << " s"
            << (probe.cut_short ? ", the last of which was not waited for" : "") << "\n"
            << printable(map.string()) << ": written\n";
}

/// What shapes a run: that it is the same on all processes.
std::string fingerprint(const PreparedCampaign& prepared) {
  std::string text = prepared.header.program_version + prepared.header.campaign_sha256;
  for (const std::string& input : prepared.header.inputs) {
    text += input.substr(input.rfind(' '));  // a path can differ from machine to machine
  }
  return text;
}

void simulate_with(ProcessTeam& team, const SimulateArgs& args, const Shard& shard) {
  std::optional<PreparedCampaign> plan;
  bool finished = false;
  const std::filesystem::path output = output_of(args, shard);
  const std::filesystem::path part = partial_results(output);
  team.agree([&] {
    const bool begun = std::filesystem::exists(part);
    const bool keep = !args.replace && !args.resume && !args.dry_run && !begun;
    if (team.leads()) check_results_place(output, !keep);
    plan.emplace(prepare_campaign(read_campaign(args.campaign)));
    if (args.resume && !args.replace && !begun) {
      finished = is_finished(output, plan->header, shard.runs_of(plan->runs.size()));
    }
    if (team.leads() && !args.dry_run && !args.resume && begun) {
      if (std::filesystem::exists(FileLock::lock_file(output))) {
        const FileLock lock(output, {.longest_wait = {}});  // refused while that campaign runs
      }
      throw InputError(part.string() +
                       ": holds the runs of an interrupted campaign; add --resume to go on "
                       "with it, or delete the file to start afresh");
    }
    return fingerprint(*plan) + (finished ? "finished" : "");
  });
  const PreparedCampaign& prepared = *plan;
  nlohmann::ordered_json summary = plan_json(prepared);
  if (!args.json) print_plan(prepared);
  if (args.dry_run) {
    if (team.leads()) report_dry_run(args, prepared, shard, summary);
    return;
  }
  if (finished) {
    if (team.leads()) print_results(output, args, summary, "nothing to do, has all runs already");
    return;
  }
  const std::string resume_hint = "clast simulate " + args.campaign + " -o " + args.output +
                                  (args.shard.empty() ? "" : " --shard " + args.shard) +
                                  " --resume";
  std::cout.flush();
  ProgressBar bar("runs", shard.runs_of(prepared.runs.size()));
  const InterruptionWatch watch;
  RunOptions options;
  options.threads = args.threads;
  options.resume = args.resume;
  options.replace = args.replace;
  options.shard = shard;
  options.team = &team;
  options.progress = [&](const ProgressStep& step) {
    bar.update(step.done);
    if (!watch.interrupted() || step.done == step.total) return;
    bar.clear();
    throw SimulationError("interrupted; " + std::to_string(step.done) + " of " +
                          std::to_string(step.total) +
                          " runs are kept. Go on with: " + resume_hint);
  };
  run_campaign(prepared, output, options);
  bar.clear();
  if (team.leads()) print_results(output, args, summary);
}

void simulate(const SimulateArgs& args) {
  if (!args.parts.empty()) return join_parts(args);
  const Shard shard = shard_from(args.shard);
  ProcessTeam team;
  if (team.leads()) return simulate_with(team, args, shard);
  silence();
  try {
    simulate_with(team, args, shard);
  } catch (const Error&) {
    // The leader knows, says why and fails. mpirun ends all as soon as one fails: it must be the
    // first to do so, or its message is lost.
  }
}

}  // namespace

void add_simulate(CLI::App& app) {
  const auto args = std::make_shared<SimulateArgs>();
  CLI::App* command = app.add_subcommand("simulate", "Run a campaign of releases");
  CLI::Option* campaign = command
                              ->add_option("campaign", args->campaign,
                                           "Campaign file (TOML); every key is in docs/formats.md")
                              ->type_name("CAMPAIGN");
  command->add_option("-o,--output", args->output, "Results file")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--threads", args->threads, "Threads to use; 0: one for each core")
      ->check(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--resume", args->resume, "Continue an interrupted campaign");
  command->add_flag("--replace", args->replace, "Replace the results that FILE holds");
  command
      ->add_option("--shard", args->shard,
                   "Do every n-th run only, from the i-th on, and write FILE with .IofN before its "
                   "extension")
      ->type_name("I/N");
  CLI::Option* merge =
      command
          ->add_option("--merge", args->parts,
                       "Instead of CAMPAIGN: join the results of all shards into one file")
          ->type_name("PARTS")
          ->excludes(campaign);
  command->add_flag("--dry-run", args->dry_run,
                    "Check everything, report what would run and the estimated time, draw "
                    "FILE.map.svg, and stop");
  command->add_flag("--json", args->json, "Print the summary as JSON");
  command->footer(
      "Ctrl-C stops after the current runs; --resume continues from there. Results do "
      "not depend on --threads, on --shard, or on the processes of mpirun, which have one thread "
      "each unless\n--threads says otherwise.\n"
      "Examples:\n"
      "  clast simulate campaign.toml --dry-run\n"
      "  clast simulate campaign.toml -o results.h5 --threads 4\n"
      "  mpirun -n 8 clast simulate campaign.toml -o results.h5\n"
      "  clast simulate campaign.toml -o results.h5 --shard "
      "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT\n"
      "  clast simulate --merge results.*of4.h5 -o results.h5");
  command->callback([args, campaign, merge] {
    if (campaign->count() == 0 && merge->count() == 0) throw CLI::RequiredError("campaign");
    simulate(*args);
  });
}

}  // namespace clast
