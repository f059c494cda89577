#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/output_folder.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "library/block_ranges.hpp"
#include "report/json/population_json.hpp"
#include "report/population_reading.hpp"
#include "report/population_report.hpp"
#include "report/text/population_text.hpp"
#include "report/text/scanned_deposit_text.hpp"

namespace clast {

namespace {

constexpr std::size_t kMaxPrintedBlocks = 1000;  // blocks in a printed table

struct ClassifyArgs {
  PopulationReportRequest request;
  std::string schemes = "sneed-folk,zingg,garcia";
  std::string size = "I";
  std::string output;
  bool json = false;
  bool replace = false;
};

void print_tables(const PopulationReport& report) {
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    if (i > 0) std::cout << "\n";
    if (report.populations.size() > 1)
      std::cout << escape_nonprintable(reported.population.name) << "\n";
    std::cout << "L, I, S: " << reported.measured << "\n\n";
    if (reported.population.blocks.size() > kMaxPrintedBlocks) {
      std::cout << reported.population.blocks.size()
                << " blocks; -o DIR writes them to classes.csv, --json prints them\n";
    } else {
      std::cout << format_blocks_table(reported.population, report.options);
    }
    std::cout << format_population_summary(reported.summary);
    if (reported.deposit) std::cout << format_scanned_deposit(*reported.deposit);
    if (reported.skipped > 0) std::cout << format_count(reported.skipped, "row") << " skipped\n";
  }
  if (report.comparison) std::cout << format_population_comparison(*report.comparison);
}

/// An option that changes nothing here was meant for something: it is refused.
void check_options_apply(const ClassifyArgs& args, const CLI::App& command) {
  const PopulationFiles &first = args.request.first, &against = args.request.against;
  const auto given = [&](const char* option) { return command.count(option) > 0; };
  const auto any = [](const std::vector<std::string>& inputs, bool library) {
    return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
      return is_block_library(input) == library;
    });
  };
  const auto need = [&](const char* option, bool applies, const char* reason) {
    if (given(option) && !applies) throw CLI::ValidationError(option, reason);
  };
  const auto names = [&](const char* scheme) {
    const std::vector<std::string>& schemes = args.request.options.schemes;
    return std::count(schemes.begin(), schemes.end(), scheme) > 0;
  };
  need("--output", !args.output.empty(), "names no folder");
  need("--replace", given("--output"), "applies to the folder of --output; add --output");
  need("--scheme", !args.request.options.schemes.empty(), "names no scheme");
  for (const auto& [option, value] :
       {std::pair{"--columns", &first.columns}, std::pair{"--units", &first.units},
        std::pair{"--against-columns", &against.columns},
        std::pair{"--against-units", &against.units}}) {
    need(option, !value->empty(), "is empty");
  }
  for (const char* option : {"--columns", "--units"}) {
    need(option, any(first.inputs, false) || any(against.inputs, false),
         "applies to tables, but every input is a library, whose axes are in metres");
  }
  for (const char* option : {"--against-columns", "--against-units"}) {
    need(option, any(against.inputs, false), "applies to tables, but --against has no table");
  }
  need("--roundness", any(first.inputs, true) || any(against.inputs, true),
       "is measured on the surface of blocks of a library, but no input is a library");
  need("--roundness", args.json, "is printed with --json only");
  need("--erdogan-limit", args.json || names("erdogan"),
       "applies to the scheme erdogan: add --scheme");
  need("--thirds", args.json || !args.output.empty() || names("sneed-folk"),
       "applies to the scheme sneed-folk: add --scheme");
}

void classify(const ClassifyArgs& args) {
  std::optional<OutputFolder> folder;
  if (!args.output.empty())
    folder.emplace(args.output, population_folder_kind(args.output), args.replace);
  const PopulationReport report = read_populations(args.request);
  if (folder) {
    write_population_report(report, folder->temporary_path());
    folder->commit();
  }
  // Only now, so that a failure is the first thing said.
  for (const ReportedPopulation& reported : report.populations) {
    for (const std::string& note : reported.brief_notes)
      std::cerr << format_for_terminal(note) << "\n";
  }
  args.json ? write_population_json(std::cout, report) : print_tables(report);
  if (!args.output.empty() && !args.json) {
    std::cout << "\nReport: "
              << escape_nonprintable((std::filesystem::path(args.output) / "report.html").string())
              << "\n";
  }
}

/// Schemes, and what is measured of the blocks.
void add_class_options(CLI::App& command, ClassifyArgs& args) {
  std::string known;
  for (const std::string& name : scheme_names()) known += name + ", ";
  command.add_option("--scheme", args.schemes, "One or more of " + known + "or all")
      ->type_name("NAME,..")
      ->capture_default_str();
  command
      .add_option("--box", args.request.reading.box,
                  "Box whose sides are L, I, S of blocks of a library: the smallest volume, the "
                  "principal axes of inertia, the longest Feret diameters as with callipers, or "
                  "the principal components of the hull's corners")
      ->check(CLI::IsMember({"smallest", "inertia", "feret", "pca"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--axis-error", args.request.reading.axis_error,
                  "Error of the axes, m; default: 0.05 for a table (tape), twice the "
                  "deviation from the scan for a library")
      ->check(number_in_range(kAxisErrorRange))
      ->type_name("M");
  command.add_flag("--thirds", args.request.options.limits.sneed_folk_thirds,
                   "Sneed & Folk: limits 1/3 and 2/3 for the second letter of a class, instead of "
                   "0.33 and 0.67");
  command
      .add_option("--erdogan-limit", args.request.options.limits.erdogan_limit,
                  "Scheme erdogan: two axes count as different if their ratio is at least this")
      ->check(number_in_range(kErdoganLimitRange))
      ->type_name("RATIO")
      ->capture_default_str();
  command
      .add_option("--roundness", args.request.reading.roundness_edge,
                  "With --json: also compute Wadell roundness of blocks of a library, on their "
                  "surface remeshed to this edge length, m")
      ->check(number_in_range(kBlockLengthRange))
      ->type_name("M");
}

void add_table_options(CLI::App& command, PopulationReportRequest& request) {
  command
      .add_option("--columns", request.first.columns,
                  "Columns of a table, by name or number from 1; also mass=.. and name=..")
      ->type_name("L=..,I=..,S=..")
      ->capture_default_str();
  command
      .add_option("--units", request.first.units,
                  "Length unit of a table: m, cm, mm, um, km, in, ft, or metres per unit; default: "
                  "from its header, otherwise m")
      ->type_name("UNIT");
  command
      .add_option("--against-columns", request.against.columns,
                  "Columns of the second population's tables; default: the same")
      ->type_name("L=..,I=..,S=..");
  command
      .add_option("--against-units", request.against.units,
                  "Length unit of the second population's tables; default: the same")
      ->type_name("UNIT");
}

}  // namespace

void add_classify_command(CLI::App& app) {
  const auto args = std::make_shared<ClassifyArgs>();
  CLI::App* command = app.add_subcommand(
      "classify", "Determine the shape classes of blocks, from libraries or tables of L, I, S");
  command
      ->add_option("inputs", args->request.first.inputs,
                   "Block libraries, or text tables of tape-measured axes (csv, tsv, txt); several "
                   "inputs form one population")
      ->required()
      ->type_name("LIB|CSV");
  command
      ->add_option("--against", args->request.against.inputs,
                   "A second population to compare with: libraries or tables")
      ->type_name("LIB|CSV");
  add_class_options(*command, *args);
  add_table_options(*command, args->request);
  command
      ->add_option(
          "--size", args->size,
          "Size of a block in size distributions: I, the sieve axis, or mean, (L I S)^(1/3)")
      ->check(CLI::IsMember({"I", "mean"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--seed", args->request.options.seed,
                   "Seed of the random samples for the p-values of fits")
      ->check(integer_in_range())
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("-o,--output", args->output,
                   "Folder for report.html, tables (csv) and diagrams (svg)")
      ->type_name("DIR");
  command->add_flag("--replace", args->replace, "Replace an existing report in the folder");
  command->add_flag("--json", args->json, "Print as JSON");
  command->footer(
      "Fractions are given with Wilson's 95 % confidence interval for the whole "
      "deposit.\nExamples:\n  clast classify blocks.h5\n"
      "  clast classify talus.csv --columns L=5,I=6,S=7,mass=4 --units cm --scheme zingg\n"
      "  clast classify talus.csv --against blocks.h5 -o classes");
  command->callback([args, command] {
    PopulationReportRequest& request = args->request;
    request.reading.box_given = command->count("--box") > 0;
    request.reading.surfaces = args->json;
    request.options.size = args->size == "I" ? SizeMeasure::kIntermediate : SizeMeasure::kMean;
    request.options.schemes =
        args->schemes == "all" ? scheme_names() : split_comma_separated(args->schemes);
    check_options_apply(*args, *command);
    check_usage([&] { request.check(); });
    classify(*args);
  });
}

}  // namespace clast
