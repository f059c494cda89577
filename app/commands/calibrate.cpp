#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/shared_runs.hpp"
#include "app/companion.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/shell_words.hpp"
#include "report/calibration_report.hpp"
#include "report/json/calibration_json.hpp"
#include "report/text/calibration_text.hpp"
#include "study/simulate/results_place.hpp"

namespace clast {

namespace {

struct CalibrateArgs {
  std::string study;
  std::string output = "posterior.h5";
  unsigned threads = 0;
  bool resume = false;
  bool replace = false;
  bool json = false;
  std::string shard;
  std::vector<std::string> parts;
};

void print_calibration(const Calibration& calibration, const std::filesystem::path& page) {
  std::cout << escape_nonprintable(describe_calibration_result(calibration)) << "\n";
  for (const std::string& finding : describe_calibration_findings(calibration)) {
    std::cout << escape_nonprintable(finding) << "\n";
  }
  std::cout << "\n"
            << format_unknowns_table(calibration) << "\n"
            << format_statistics_table(calibration) << "\n"
            << format_ground_tables(calibration) << "\n"
            << escape_nonprintable(calibration.file.string()) << "\n"
            << escape_nonprintable(page.string()) << "\n";
}

void print_members(const Calibration& calibration, const Shard& shard) {
  std::size_t members = 0;
  for (std::uint32_t i = 0; i < calibration.study.design.member_count; ++i)
    members += shard.contains(i);
  std::cout << escape_nonprintable(calibration.file.string()) << ": " << members << " of "
            << format_count(calibration.study.design.member_count, "member")
            << " simulated. When all shards are finished, join them: "
            << escape_nonprintable(
                   format_shell_command({"clast", "calibrate", calibration.study.file.string()}))
            << " --merge PARTS\n";
}

std::string resume_command(const CalibrateArgs& args) {
  std::vector<std::string> words = {"clast", "calibrate", args.study, "-o", args.output};
  if (!args.shard.empty()) words.insert(words.end(), {"--shard", args.shard});
  words.push_back("--resume");
  return format_shell_command(words);
}

/// The file itself or that of the shard.
void run_calibration_with(ProcessTeam& team, const CalibrateArgs& args, CalibrationOptions options,
                          const std::filesystem::path& output, const InterruptionWatch& watch) {
  std::optional<CalibrationStudy> read;
  const bool whole = options.shard.count == 1;
  team.check_agreement([&] {
    read.emplace(read_calibration_study(args.study));
    if (team.is_leader() && whole) check_calibration_output(output, options);
    return std::string();
  });
  const CalibrationStudy& study = *read;
  options.team = &team;
  if (!team.is_leader()) return simulate_members_for_leader(study, options);
  ProgressBar bar("members", study.sites.size() * study.design.member_count);
  bool started = false;
  options.progress = [&](const ProgressUpdate& step) {
    if (!std::exchange(started, true)) bar.start_from(step.done_before);
    bar.update(step.done);
    if (!watch.interrupted() || step.done == step.total) return;
    bar.clear();
    throw SimulationError("interrupted; " + std::to_string(step.done) + " of " +
                          std::to_string(step.total) +
                          " members are kept. Go on with: " + resume_command(args));
  };
  const Calibration calibration = whole ? calibrate_and_report(study, output, options)
                                        : run_calibration(study, output, options);
  bar.clear();
  if (!whole) {
    print_members(calibration, options.shard);
  } else if (args.json) {
    std::cout << calibration_json(calibration).dump(2) << "\n";
  } else {
    print_calibration(calibration, calibration_page_file(output));
  }
}

void calibrate_study(const CalibrateArgs& args) {
  CalibrationOptions options;
  options.threads = args.threads;
  options.resume = args.resume;
  options.replace = args.replace;
  options.parts.assign(args.parts.begin(), args.parts.end());
  const std::optional<Shard> shard = parse_shard(args.shard);
  options.shard = shard.value_or(Shard());
  check_usage([&] { calibration_page_file(args.output); });
  const InterruptionWatch watch;  // before any file is touched
  run_in_team([&](ProcessTeam& team) {
    run_calibration_with(team, args, options, shard_results_path(args.output, shard), watch);
  });
}

}  // namespace

void add_calibrate_command(CLI::App& app) {
  const auto args = std::make_shared<CalibrateArgs>();
  CLI::App* command = &add_companion_command(app, "calibrate");
  command
      ->add_option("study", args->study, "Study file (TOML); docs/formats.md describes every key")
      ->required()
      ->type_name("STUDY");
  command
      ->add_option("-o,--output", args->output,
                   "Posterior file to write; an HTML page of the same name is written beside it")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--threads", args->threads, "Threads to use; 0: one for each core")
      ->check(integer_in_range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  CLI::Option* resume = command->add_flag("--resume", args->resume,
                                          "Reuse the simulated members of an interrupted "
                                          "calibration or of one with other observations");
  command->add_flag("--replace", args->replace, "Replace an existing posterior in FILE");
  CLI::Option* shard =
      command
          ->add_option("--shard", args->shard,
                       "Simulate only every n-th member, starting with the i-th, without "
                       "inference; the output is FILE with .IofN before its extension")
          ->type_name("I/N");
  command
      ->add_option("--merge", args->parts,
                   "Read the members from the files of all shards instead of simulating them")
      ->type_name("PARTS")
      ->excludes(shard)
      ->excludes(resume);
  command->add_flag("--json", args->json, "Print the summary as JSON")->excludes(shard);
  command->footer(
      "Simulates parameter sets that are evenly distributed over their ranges, fits how the "
      "observed statistics depend on the parameters, and draws parameter sets that explain the "
      "observations.\nCtrl-C stops after the current member; --resume continues the "
      "calibration.\nResults do not depend on --threads, on --shard, or on the number of mpirun "
      "processes.\nEach process has one thread unless --threads is given.\nExamples:\n"
      "  clast calibrate study.toml -o posterior.h5\n"
      "  mpirun -n 8 clast calibrate study.toml -o posterior.h5\n"
      "  clast calibrate study.toml -o posterior.h5 --shard "
      "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT\n"
      "  clast calibrate study.toml -o posterior.h5 --merge posterior.*of4.h5");
  command->callback([args] { calibrate_study(*args); });
}

}  // namespace clast
