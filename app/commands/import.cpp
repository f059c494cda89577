#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/campaign_summary.hpp"
#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/interruption.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "report/json/campaign_json.hpp"
#include "study/engines/engine_results.hpp"

namespace clast {

namespace {

struct ImportArgs {
  EngineResultsOptions options;
  std::string output = "results.h5";
  bool json = false;
};

void import_results(ImportArgs& args) {
  ProgressBar bar("runs", 0);
  const InterruptionWatch watch;
  args.options.progress = [&](const ProgressUpdate& step) {
    bar.update(step.done);
    if (watch.interrupted()) throw SimulationError("interrupted; nothing was written");
  };
  const EngineImportSummary found = import_engine_results(args.options, args.output);
  bar.clear();
  const CampaignResults results = read_results(args.output);
  if (args.json) {
    nlohmann::ordered_json json = {{"runs", found.runs},
                                   {"planned_runs", found.planned},
                                   {"scenes_without_results", found.without_output},
                                   {"notes", found.notes}};
    json.update(outcome_json(results));
    std::cout << json.dump(2) << "\n";
    return;
  }
  print_outcome(results);
  for (const std::string& note : found.notes)
    std::cout << "note: " << escape_nonprintable(note) << "\n";
  std::cout << escape_nonprintable(args.output) << ": " << found.runs << " of "
            << format_count(found.planned, "planned run") << "\n";
}

}  // namespace

void add_import_command(CLI::App& app) {
  const auto args = std::make_shared<ImportArgs>();
  CLI::App* command = &add_companion_command(app, "import");
  command->add_option("engine", args->options.engine, "Engine that ran the scenes: rockable")
      ->required()
      ->check(CLI::IsMember(importable_engines()))
      ->type_name("ENGINE");
  command
      ->add_option("scenes", args->options.scenes,
                   "Folder written by clast export, with the conf files of each run in the folder "
                   "of that run")
      ->required()
      ->type_name("DIR");
  command->add_option("-o,--output", args->output, "Results file")
      ->type_name("FILE")
      ->capture_default_str();
  command
      ->add_option("--campaign", args->options.campaign,
                   "The exported campaign, if it is no longer in its folder")
      ->type_name("FILE");
  command->add_flag("--replace", args->options.replace, "Replace existing results in FILE");
  command->add_flag("--json", args->json, "Print the summary as JSON");
  command->footer(
      "Positions, speeds, energies and crossings of barriers come from the states in the conf "
      "files.\nPenetration, impacts and dissipation by mechanism require contact data; they are "
      "omitted, "
      "and reports state this.\n"
      "Example:\n"
      "  clast export campaign.toml --to rockable -o scenes\n"
      "  for run in scenes/run*; do (cd $run && rockable input.txt); done\n"
      "  clast import rockable scenes -o rockable.h5\n"
      "  clast simulate campaign.toml -o clast.h5\n"
      "  clast compare clast.h5 rockable.h5 --by engine -o report");
  command->callback([args] { import_results(*args); });
}

}  // namespace clast
