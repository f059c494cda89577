#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/printable.hpp"
#include "report/calibration_report.hpp"
#include "report/json/calibration_json.hpp"
#include "report/text/calibration_text.hpp"

namespace clast {

namespace {

struct CalibrateArgs {
  std::string study;
  std::string output = "posterior.h5";
  unsigned threads = 0;
  bool resume = false;
  bool replace = false;
  bool json = false;
};

void print_calibration(const Calibration& calibration, const std::filesystem::path& page) {
  std::cout << printable(calibration_answer(calibration)) << "\n";
  for (const std::string& finding : calibration_findings(calibration)) {
    std::cout << printable(finding) << "\n";
  }
  std::cout << "\n"
            << unknowns_text(calibration) << "\n"
            << figures_text(calibration) << "\n"
            << ground_block(calibration) << "\n"
            << printable(calibration.file.string()) << "\n"
            << printable(page.string()) << "\n";
}

void calibrate_study(const CalibrateArgs& args) {
  const CalibrationStudy study = read_calibration_study(args.study);
  std::filesystem::path page;
  check_usage([&] { page = calibration_page_file(args.output); });
  ProgressBar bar("members", study.sites.size() * study.design.members);
  const InterruptionWatch watch;
  CalibrateOptions options;
  options.threads = args.threads;
  options.resume = args.resume;
  options.replace = args.replace;
  bool started = false;
  options.progress = [&](const ProgressStep& step) {
    if (!std::exchange(started, true)) bar.start_from(step.before);
    bar.update(step.done);
    if (!watch.interrupted() || step.done == step.total) return;
    bar.clear();
    throw SimulationError("interrupted; " + std::to_string(step.done) + " of " +
                          std::to_string(step.total) +
                          " members are kept. Go on with: clast calibrate " + args.study + " -o " +
                          args.output + " --resume");
  };
  const Calibration calibration = calibrate_with_page(study, args.output, options);
  bar.clear();
  if (args.json) {
    std::cout << calibration_json(calibration).dump(2) << "\n";
  } else {
    print_calibration(calibration, page);
  }
}

}  // namespace

void add_calibrate(CLI::App& app) {
  const auto args = std::make_shared<CalibrateArgs>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Find ground parameters from what was observed, with their uncertainty");
  command->add_option("study", args->study, "Study file (TOML); every key is in docs/formats.md")
      ->required()
      ->type_name("STUDY");
  command
      ->add_option("-o,--output", args->output,
                   "Posterior file; a page is written beside it, with the extension .html")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--threads", args->threads, "Threads to use; 0: one for each core")
      ->check(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--resume", args->resume,
                    "Take over the members that an interrupted calibration, or one with other "
                    "observations, has simulated");
  command->add_flag("--replace", args->replace, "Replace the posterior that FILE holds");
  command->add_flag("--json", args->json, "Print the summary as JSON");
  command->footer(
      "Simulates sets of parameters that fill their ranges evenly, learns how the observed figures "
      "depend on them, and draws the parameters that explain what was observed.\nCtrl-C stops "
      "after the current member; --resume continues from there. Results do not depend on "
      "--threads.\nExample:\n  clast calibrate study.toml -o posterior.h5");
  command->callback([args] { calibrate_study(*args); });
}

}  // namespace clast
