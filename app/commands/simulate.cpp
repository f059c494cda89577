#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/commands/campaign_summary.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/shared_runs.hpp"
#include "app/companion.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/printable.hpp"
#include "core/shell_words.hpp"
#include "report/json/campaign_json.hpp"
#include "report/maps/site_map.hpp"
#include "report/maps/svg_map.hpp"
#include "report/text/trends_text.hpp"
#include "study/compare/outcome.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "study/simulate/results_place.hpp"

namespace clast {

namespace {

struct SimulateArgs {
  std::string campaign;
  std::string output = "results.h5";
  unsigned threads = 0;
  bool resume = false;
  bool replace = false;
  double checkpoint_interval = 300.0;  ///< s
  bool dry_run = false;
  bool json = false;
  double margin = 0.0;  ///< m; 0: none
  std::string shard;
  std::vector<std::string> parts;
};

/// @param done  what became of the file
void print_results(const std::filesystem::path& file, const SimulateArgs& args,
                   nlohmann::ordered_json summary, const std::string& done = "written") {
  const CampaignResults results = read_results(file);
  if (args.json) {
    summary.update(outcome_json(results));
    std::cout << summary.dump(2) << "\n";
  } else {
    print_outcome(results);
    std::cout << escape_nonprintable(file.string()) << ": " << done << "\n";
  }
  check_no_failed_runs(results, file);
}

void join_parts(const SimulateArgs& args) {
  const std::filesystem::path target = args.output;
  check_results_target(target, args.replace);
  merge_results({args.parts.begin(), args.parts.end()}, target);
  print_results(target, args, nlohmann::ordered_json::object());
}

constexpr double kProbeTime = 2.0;  ///< s that a dry run spends on runs

/// Estimates which differences the campaign could detect, from the trial runs.
PlannedPower power_of(const SimulateArgs& args, const CampaignPlan& prepared,
                      const RunTimeProbe& probe) {
  PlannedPower plan = compute_planned_power(prepared, probe);
  if (args.margin > 0.0) plan.margin = args.margin;
  return plan;
}

/// Expected time, what could be found, and the map.
void report_dry_run(const SimulateArgs& args, const CampaignPlan& prepared, const Shard& shard,
                    nlohmann::ordered_json summary) {
  std::filesystem::path map = args.output;
  map.replace_extension(".map.svg");
  const OverwritePolicy rules{.kind = file_kind_by_extension(map)};
  check_output_target(map, rules);
  const RunTimeProbe probe = measure_run_time(prepared, kProbeTime);
  const unsigned threads = resolve_thread_count(args.threads);
  const std::size_t together = prepared.header.runs_per_realisation();
  const std::size_t items = shard.run_count(prepared) / together;
  const double each = probe.time_per_run * static_cast<double>(together);
  const double expected = estimate_time(prepared, probe, shard, threads);
  write_output(map, draw_svg_map(make_site_map(prepared.header)), rules);
  const PlannedPower power = power_of(args, prepared, probe);
  if (args.json) {
    summary.update(power_json(power));
    summary["expected_time_s"] = expected;
    summary["probed_runs"] = probe.runs;
    summary["probe_cut_short"] = probe.last_run_stopped;
    summary["probe_failure"] = probe.first_failure;
    summary["threads"] = threads;
    summary["map"] = map.string();
    std::cout << summary.dump(2) << "\n";
    return;
  }
  if (!probe.first_failure.empty()) {
    std::cout << "warning: a trial run failed, so the estimated time is unreliable: "
              << escape_nonprintable(probe.first_failure) << "\n";
  }
  const std::string sentence = describe_planned_power(power);
  std::cout << (probe.is_upper_bound ? "at most " : "about ") << format_duration(expected)
            << " for "
            << format_count(items, prepared.header.persistent_blocks ? "realisation" : "run")
            << " on " << format_count(threads, "thread") << ", judging by "
            << format_count(probe.runs / together,
                            prepared.header.persistent_blocks ? "realisation" : "run")
            << " of " << format_rounded(each, 2) << " s"
            << (!probe.last_run_stopped  ? ""
                : probe.runs == together ? ", which was stopped early"
                                         : ", the last of which was stopped early")
            << "\n"
            << (sentence.empty() ? "" : sentence + "\n") << escape_nonprintable(map.string())
            << ": written\n";
  print_stiffness(prepared);
}

/// Text that is equal on all processes if they simulate the same runs.
std::string fingerprint(const CampaignPlan& prepared) {
  std::string text = prepared.header.program_version + prepared.header.physics_digest +
                     prepared.header.campaign_sha256;
  for (const std::string& input : prepared.header.inputs) {
    text += input.substr(input.rfind(' '));  // a path can differ from machine to machine
  }
  return text;
}

/// The campaign, with a bar while bodies are made.
CampaignPlan prepared_campaign(const SimulateArgs& args, const ProcessTeam& team,
                               const InterruptionWatch& watch) {
  const auto check_interrupted = [&] {
    if (watch.interrupted()) throw SimulationError("interrupted; nothing was run");
  };
  std::unique_ptr<ProgressBar> bar;
  BlockPreparationOptions making{.threads = args.threads};
  making.progress = [&](const ProgressUpdate& step) {
    check_interrupted();
    if (!team.is_leader()) return;
    if (!bar) bar = std::make_unique<ProgressBar>("bodies", step.total);
    bar->update(step.done);
  };
  CampaignPlan prepared = prepare_campaign(read_campaign(args.campaign), making);
  check_interrupted();
  return prepared;
}

void simulate_with(ProcessTeam& team, const SimulateArgs& args,
                   const std::optional<Shard>& given_shard, const InterruptionWatch& watch) {
  const Shard shard = given_shard.value_or(Shard());
  std::optional<CampaignPlan> plan;
  bool finished = false;
  const std::filesystem::path output = shard_results_path(args.output, given_shard);
  const std::filesystem::path part = results_journal_path(output);
  team.check_agreement([&] {
    const bool begun = std::filesystem::exists(part);
    const bool keep = !args.replace && !args.resume && !args.dry_run && !begun;
    if (team.is_leader()) check_results_target(output, !keep);
    plan.emplace(prepared_campaign(args, team, watch));
    if (args.resume && !args.replace && !begun) {
      finished = has_finished_results(output, plan->header, shard.run_count(*plan));
    }
    if (team.is_leader() && !args.dry_run && !args.resume) check_not_interrupted(output);
    return fingerprint(*plan) + (finished ? "finished" : "");
  });
  const CampaignPlan& prepared = *plan;
  nlohmann::ordered_json summary = plan_json(prepared);
  if (!args.json) print_plan(prepared);
  if (args.dry_run) {
    if (team.is_leader()) report_dry_run(args, prepared, shard, summary);
    return;
  }
  if (finished) {
    if (team.is_leader())
      print_results(output, args, summary, "nothing to do, all runs are stored already");
    return;
  }
  std::vector<std::string> resume = {"clast", "simulate", args.campaign, "-o", args.output};
  if (!args.shard.empty()) resume.insert(resume.end(), {"--shard", args.shard});
  resume.push_back("--resume");
  const std::string resume_hint = format_shell_command(resume);
  std::cout.flush();
  ProgressBar bar("runs", shard.run_count(prepared));
  CampaignRunOptions options;
  options.threads = args.threads;
  options.resume = args.resume;
  options.replace = args.replace;
  options.checkpoint_interval = args.checkpoint_interval;
  options.shard = shard;
  options.team = &team;
  bool started = false;
  options.progress = [&](const ProgressUpdate& step) {
    if (!std::exchange(started, true)) bar.start_from(step.done_before);
    bar.update(step.done, step.activity);
    if (!watch.interrupted() || step.done == step.total) return;
    bar.clear();
    throw SimulationError("interrupted; " + std::to_string(step.done) + " of " +
                          std::to_string(step.total) + " runs" +
                          (prepared.header.persistent_blocks
                               ? " and the checkpoints of unfinished realisations"
                               : "") +
                          " are kept. Continue with: " + resume_hint);
  };
  run_campaign(prepared, output, options);
  bar.clear();
  if (!team.is_leader()) return;
  print_results(output, args, summary);
  if (!args.json) print_stiffness(prepared);
}

void simulate(const SimulateArgs& args) {
  if (!args.parts.empty()) return join_parts(args);
  const std::optional<Shard> shard = parse_shard(args.shard);
  const InterruptionWatch watch;  // before any file is touched
  run_in_team([&](ProcessTeam& team) { simulate_with(team, args, shard, watch); });
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  const auto args = std::make_shared<SimulateArgs>();
  CLI::App* command = &add_companion_command(app, "simulate");
  CLI::Option* campaign =
      command
          ->add_option("campaign", args->campaign,
                       "Campaign file (TOML); docs/formats.md describes every key")
          ->type_name("CAMPAIGN");
  command->add_option("-o,--output", args->output, "Results file")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--threads", args->threads, "Threads to use; 0: one for each core")
      ->check(integer_in_range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--resume", args->resume, "Continue an interrupted campaign");
  command->add_flag("--replace", args->replace, "Replace existing results in FILE");
  command
      ->add_option("--checkpoint-interval", args->checkpoint_interval,
                   "Persistent blocks: seconds between checkpoints of a realisation, from which "
                   "--resume continues after a crash; 0: checkpoints only on Ctrl-C")
      ->check(number_in_range({0.0, 1e6, "s"}))
      ->type_name("S")
      ->capture_default_str();
  command
      ->add_option("--shard", args->shard,
                   "Simulate only every n-th run (realisation, if blocks are persistent), starting "
                   "with the i-th; the output is FILE with .IofN before its extension")
      ->type_name("I/N");
  CLI::Option* merge =
      command
          ->add_option("--merge", args->parts,
                       "Instead of CAMPAIGN: join the results of all shards into one file")
          ->type_name("PARTS")
          ->excludes(campaign);
  command->add_flag("--dry-run", args->dry_run,
                    "Check everything, report the planned runs and the estimated time, draw "
                    "FILE.map.svg, and stop");
  command
      ->add_option("--margin", args->margin,
                   "Difference in runout that matters: the dry run reports how many runs are "
                   "needed to detect it")
      ->check(number_in_range({1e-3, 1e5, "m"}))
      ->type_name("M");
  command->add_flag("--json", args->json, "Print the summary as JSON");
  command->footer(
      "Ctrl-C stops after the current runs; --resume continues the campaign.\nWith persistent "
      "blocks, it writes checkpoints and stops at once; other mpirun processes finish their "
      "realisations.\nResults do not depend on interruptions, on --threads, on --shard, or on the "
      "number of mpirun processes.\nEach process has one thread unless --threads is given.\n"
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
