#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/printable.hpp"
#include "report/comparison_report.hpp"
#include "report/scene/vtk_animation.hpp"
#include "study/comparison.hpp"

namespace clast {

namespace {

struct CompareArgs {
  std::vector<std::string> results;
  std::string folder = "comparison";
  std::vector<std::string> by;
  std::string measured;
  std::size_t animated = 0;
  bool replace = false;
};

void compare_results(const CompareArgs& args) {
  if (args.folder.empty()) throw CLI::ValidationError("--output", "names no folder");
  OutputFolder folder(args.folder, comparison_folder(), args.replace);
  std::vector<CampaignResults> results;
  for (const std::string& file : args.results) results.push_back(read_results(file));
  CompareOptions options;
  options.by = args.by;
  if (!args.measured.empty()) options.measured = args.measured;
  const Comparison comparison = compare(std::move(results), options);
  std::vector<std::filesystem::path> written = write_comparison(comparison, folder.temporary());
  if (args.animated > 0) {
    const std::filesystem::path animation =
        write_animation(folder.temporary() / "animation", comparison, args.animated);
    if (animation.empty()) {
      throw InputError(
          "no trajectory is stored, so nothing can be animated; set [run] "
          "trajectory_interval_s above zero");
    }
    written.insert(written.begin(), animation);
  }
  folder.commit();
  for (const std::string& warning : comparison.warnings) {
    std::cerr << "clast: warning: " << shown(warning) << "\n";
  }
  for (const Difference& difference : comparison.differences) {
    // Classes are what the study is about; the rest is in the table.
    if (comparison.groups[difference.first].kind == GroupKind::kGarcia && difference.found()) {
      std::cout << printable(in_words(difference, comparison)) << "\n";
    }
  }
  for (const std::filesystem::path& file : written) {
    const std::filesystem::path name = file.lexically_relative(folder.temporary());
    std::cout << printable((std::filesystem::path(args.folder) / name).string()) << "\n";
  }
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto args = std::make_shared<CompareArgs>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compare shapes and classes: tables, map layers and one HTML report");
  command->add_option("results", args->results, "Results files of one or more campaigns")
      ->required()
      ->type_name("RESULTS");
  command->add_option("-o,--output", args->folder, "Folder, created if missing")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace an existing comparison in the folder");
  command
      ->add_option("--by", args->by,
                   "Group by the values of a column of runs.csv too, for example release_set, "
                   "block_group, mass_kg (in quarters); may be given again")
      ->type_name("COLUMN")
      ->allow_extra_args(false);
  command
      ->add_option("--animate", args->animated,
                   "Write animation/animation.pvd for ParaView, with this many runs")
      ->type_name("RUNS")
      ->check(whole_number(0, 1000000))
      ->capture_default_str();
  command
      ->add_option("--measured", args->measured,
                   "Table of stops observed in the field (columns x and y, m; optionally start_x, "
                   "start_y, block, shape), compared with the simulated ones")
      ->type_name("CSV");
  command->footer(
      "Writes tables (runs, barriers, crossings, deposits, impacts, differences, profiles, ...), "
      "map "
      "layers and report.html,\nwhose path comes last. Units are in the column names.\n"
      "Example:\n  clast compare compact.h5 elongated.h5 -o comparison --by release_set");
  command->callback([args] { compare_results(*args); });
}

}  // namespace clast
