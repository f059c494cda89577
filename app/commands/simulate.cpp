#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/progress.hpp"
#include "app/text_table.hpp"
#include "core/error.hpp"
#include "study/campaign_runner.hpp"

namespace clast {

namespace {

struct SimulateArgs {
  std::string campaign;
  std::string output = "results.h5";
  unsigned threads = 0;
  bool resume = false;
  bool dry_run = false;
  bool json = false;
};

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupted = 0;

/// The first Ctrl-C ends the campaign after the runs under way; the second ends it at once.
void stop_politely(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

nlohmann::ordered_json plan_json(const PreparedCampaign& prepared) {
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  for (const Block& block : prepared.blocks) blocks.push_back(block.id);
  const ContactStiffness& stiffness = prepared.stiffness.stiffness;
  std::vector<std::string> warnings = prepared.header.warnings;
  return {{"runs", prepared.runs.size()},
          {"blocks", blocks},
          {"release_points", prepared.header.release_points.size()},
          {"normal_stiffness_n_m", stiffness.normal},
          {"tangential_stiffness_n_m", stiffness.tangential},
          {"rolling_stiffness_n_m_rad", stiffness.rolling},
          {"time_step_s", stiffness.time_step},
          {"settled_depth_m", prepared.stiffness.settled_depth},
          {"impact_depth_m", prepared.stiffness.impact_depth},
          {"warnings", warnings}};
}

void print_plan(const PreparedCampaign& prepared) {
  const ContactStiffness& stiffness = prepared.stiffness.stiffness;
  std::cout << counted(prepared.runs.size(), "run") << ": "
            << counted(prepared.blocks.size(), "block") << ", "
            << counted(prepared.header.release_points.size(), "release point") << ", "
            << counted(prepared.campaign.release.orientations.size(), "orientation") << "\n"
            << "k_n " << rounded(stiffness.normal) << " N/m, k_t " << rounded(stiffness.tangential)
            << " N/m, time step " << rounded(stiffness.time_step, 3) << " s; rests at most "
            << rounded(prepared.stiffness.settled_depth, 2) << " m deep, impacts go at most "
            << rounded(prepared.stiffness.impact_depth, 2) << " m deep\n";
  for (const std::string& warning : prepared.header.warnings) {
    std::cout << "warning: " << warning << "\n";
  }
}

constexpr std::array<StopReason, 4> kReasons = {StopReason::kRest, StopReason::kLeftTerrain,
                                                StopReason::kMaxTime, StopReason::kError};

/// What came out, over all runs.
struct Outcome {
  std::array<std::size_t, 4> reasons = {};
  std::size_t below_ground = 0;
  double largest_energy_error = 0.0;
  std::string first_error;
};

Outcome outcome_of(const CampaignResults& results) {
  Outcome outcome;
  for (const RunRecord& run : results.runs) {
    const auto reason = std::find(kReasons.begin(), kReasons.end(), run.result.stop_reason);
    ++outcome.reasons[static_cast<std::size_t>(reason - kReasons.begin())];
    if (run.result.below_ground) ++outcome.below_ground;
    outcome.largest_energy_error = std::max(outcome.largest_energy_error, run.result.energy.error);
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
  if (!outcome.first_error.empty()) std::cout << "first error: " << outcome.first_error << "\n";
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
          {"largest_energy_error", outcome.largest_energy_error}};
}

void simulate(const SimulateArgs& args) {
  const PreparedCampaign prepared = prepare_campaign(read_campaign(args.campaign));
  nlohmann::ordered_json summary = plan_json(prepared);
  if (!args.json) print_plan(prepared);
  if (args.dry_run) {
    if (args.json) std::cout << summary.dump(2) << "\n";
    return;
  }
  const std::string part = args.output + ".part";
  if (!args.resume && std::filesystem::exists(part)) {
    throw InputError(part +
                     ": holds the runs of an interrupted campaign; add --resume to go on "
                     "with it, or delete the file to start afresh");
  }
  const std::string resume_hint =
      "clast simulate " + args.campaign + " -o " + args.output + " --resume";
  std::cout.flush();
  Progress progress("runs", prepared.runs.size());
  RunOptions options;
  options.threads = args.threads;
  options.resume = args.resume;
  options.progress = [&](std::size_t done, std::size_t planned) {
    progress.update(done);
    if (!interrupted || done == planned) return;
    progress.clear();
    throw SimulationError("interrupted; the finished runs are kept. Go on with: " + resume_hint);
  };
  std::signal(SIGINT, stop_politely);
  run_campaign(prepared, args.output, options);
  std::signal(SIGINT, SIG_DFL);
  progress.clear();

  const CampaignResults results = read_results(args.output);
  if (args.json) {
    summary.update(outcome_json(results));
    std::cout << summary.dump(2) << "\n";
    return;
  }
  print_outcome(results);
  std::cout << args.output << ": written\n";
}

}  // namespace

void add_simulate(CLI::App& app) {
  const auto args = std::make_shared<SimulateArgs>();
  CLI::App* command = app.add_subcommand("simulate", "Run a campaign of releases");
  command
      ->add_option("campaign", args->campaign,
                   "Campaign file (TOML); every key is in docs/formats.md")
      ->required()
      ->type_name("CAMPAIGN");
  command->add_option("-o,--output", args->output, "Results file")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--threads", args->threads, "Threads to use; 0: one for each core")
      ->check(number_between(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--resume", args->resume, "Go on with an interrupted campaign");
  command->add_flag("--dry-run", args->dry_run, "Check everything, say what would run, and stop");
  command->add_flag("--json", args->json, "Print the summary as JSON");
  command->footer(
      "Ctrl-C stops after the runs under way; --resume goes on from there. Results do "
      "not depend on --threads.\n"
      "Examples:\n"
      "  clast simulate campaign.toml --dry-run\n"
      "  clast simulate campaign.toml -o results.h5 --threads 4");
  command->callback([args] { simulate(*args); });
}

}  // namespace clast
