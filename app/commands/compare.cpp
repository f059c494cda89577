#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "core/error.hpp"
#include "core/files/output_folder.hpp"
#include "core/printable.hpp"
#include "report/comparison_report.hpp"
#include "report/page_pdf.hpp"
#include "report/text/effects_text.hpp"
#include "report/text/key_results_text.hpp"
#include "report/text/measured_text.hpp"
#include "report/text/trends_text.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

namespace {

struct CompareArgs {
  std::vector<std::string> results;
  std::string folder = "comparison";
  std::vector<std::string> by;
  std::string measured;
  std::size_t animated_runs = 0;
  bool replace = false;
  bool summary = false;
  bool pdf = false;
  bool effects = false;
  double margin = 0.0;  ///< m; 0: none
};

Comparison read_and_compare(const CompareArgs& args) {
  std::vector<CampaignResults> results;
  for (const std::string& file : args.results) results.push_back(read_results(file));
  ComparisonOptions options;
  options.by = args.by;
  if (!args.measured.empty()) options.measured = args.measured;
  if (args.margin > 0.0) options.margin = args.margin;
  return compare(std::move(results), options);
}

void print_warnings(const Comparison& comparison) {
  for (const std::string& warning : comparison.warnings) {
    std::cerr << "clast: warning: " << format_for_terminal(warning) << "\n";
  }
}

void print_lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::cout << escape_nonprintable(line) << "\n";
}

void print_effects(const CompareArgs& args, const ComparisonAnalyses& analyses) {
  if (!args.effects) return;
  print_lines(describe_effects(analyses.design_effects()));
  print_lines(describe_trends(analyses.shape_trends(), analyses.comparison().margin));
}

void compare_results(const CompareArgs& args) {
  if (args.folder.empty()) throw CLI::ValidationError("--output", "names no folder");
  ComparisonReportOptions extras{.animated_runs = args.animated_runs};
  if (args.pdf) extras.browser = find_browser();
  OutputFolder folder(args.folder, comparison_folder_kind(), args.replace);
  const Comparison comparison = read_and_compare(args);
  const ComparisonAnalyses analyses(comparison);
  const WrittenReport filled = write_report_folder(folder, analyses, extras);
  print_warnings(comparison);
  if (args.summary) {
    print_lines(describe_results_and_warnings(comparison, analyses.key_results()));
  } else {
    print_lines(describe_key_results(comparison, analyses.key_results()));
    print_lines(describe_measured_stops(comparison));
  }
  print_effects(args, analyses);
  for (const std::filesystem::path& file : filled.files) {
    std::cout << escape_nonprintable((std::filesystem::path(args.folder) / file).string()) << "\n";
  }
  if (filled.pdf_failure) {
    throw InputError(args.folder +
                     " holds the report, but report.pdf could not be made: " + *filled.pdf_failure);
  }
}

/// The first screen alone; no folder is written.
void print_summary(const CompareArgs& args) {
  const Comparison comparison = read_and_compare(args);
  print_lines(describe_results_and_warnings(comparison, summarise_key_results(comparison)));
  print_effects(args, comparison);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  const auto args = std::make_shared<CompareArgs>();
  CLI::App* command = &add_companion_command(app, "compare");
  command->add_option("results", args->results, "Results files of one or more campaigns")
      ->required()
      ->type_name("RESULTS");
  command->add_option("-o,--output", args->folder, "Folder, created if missing")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace an existing comparison in the folder");
  command
      ->add_option("--by", args->by,
                   "Also group by a column of runs.csv, for example release_set, "
                   "block_group, mass_kg (in quarters); may be given several times")
      ->type_name("COLUMN")
      ->allow_extra_args(false);
  command
      ->add_option("--animate", args->animated_runs,
                   "Write animation/animation.pvd for ParaView, with this number of runs")
      ->type_name("RUNS")
      ->check(integer_in_range(0, 1000000))
      ->capture_default_str();
  command
      ->add_option("--measured", args->measured,
                   "Table of stops observed in the field (columns x and y, m; optionally start_x, "
                   "start_y, block, shape), compared with the simulated ones")
      ->type_name("CSV");
  command->add_flag("--effects", args->effects,
                    "Print the fractions of the variance of runout, lateral angle, energy and "
                    "barrier passage that are explained by form, mass, orientation and release "
                    "point, if every combination was run, and the trends with block shape");
  command
      ->add_option("--margin", args->margin,
                   "Largest negligible difference in runout: test whether differences between "
                   "blocks are smaller, and report the number of runs that the test requires")
      ->check(number_in_range({1e-3, 1e5, "m"}))
      ->type_name("M");
  command->add_flag("--pdf", args->pdf,
                    "Write the report as report.pdf too (needs Chromium or Chrome)");
  command->add_flag("--summary", args->summary,
                    "Print the first screen of the report as text; without --output nothing is "
                    "written");
  command->footer(
      "Writes tables (runs, barriers, crossings, deposits, impacts, differences, profiles, ...), "
      "map layers and report.html.\nThe path of the report is printed last. Units are in the "
      "column names.\n"
      "Example:\n  clast compare compact.h5 elongated.h5 -o comparison --by release_set");
  command->callback([args, command] {
    const bool writes = command->count("--output") > 0 || args->pdf || args->animated_runs > 0;
    if (args->summary && !writes) return print_summary(*args);
    compare_results(*args);
  });
}

}  // namespace clast
