#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/population_print.hpp"
#include "app/population_reading.hpp"
#include "app/text_table.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/output_folder.hpp"
#include "core/printable.hpp"
#include "library/block_ranges.hpp"
#include "report/json/block_json.hpp"
#include "report/json/population_json.hpp"
#include "report/population_report.hpp"

namespace clast {

namespace {

constexpr std::size_t kMostPrinted = 1000;  // blocks in a printed table

using Json = nlohmann::ordered_json;

struct ClassifyArgs {
  PopulationFiles first = {{}, "L=L,I=I,S=S", ""};
  PopulationFiles against;  ///< without columns or units: those of the first
  BlockReading reading;
  std::string schemes = "sneed-folk,zingg,garcia";
  SchemeOptions limits;
  std::string size = "I";
  std::string output;
  std::uint64_t seed = 1;
  bool json = false;
  bool replace = false;
};

std::vector<std::string> schemes_from(const std::string& text) {
  if (text == "all") return scheme_names();
  const std::vector<std::string> schemes = split_list(text);
  if (schemes.empty()) throw CLI::ValidationError("--scheme", "names no scheme");
  for (const std::string& scheme : schemes) {
    if (std::count(schemes.begin(), schemes.end(), scheme) > 1) {
      throw CLI::ValidationError("--scheme", "names " + scheme + " more than once");
    }
    try {
      class_names(scheme);
    } catch (const InputError& error) {
      throw CLI::ValidationError("--scheme", error.what());
    }
  }
  return schemes;
}

void print_tables(const PopulationReport& report, const std::vector<ReadPopulation>& sources) {
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    if (i > 0) std::cout << "\n";
    if (report.populations.size() > 1) std::cout << printable(reported.population.name) << "\n";
    std::cout << "L, I, S: " << reported.measured << "\n\n";
    if (reported.population.blocks.size() > kMostPrinted) {
      std::cout << reported.population.blocks.size()
                << " blocks; -o DIR writes them to classes.csv, --json prints them\n";
    } else {
      std::cout << blocks_text(reported.population, report.options);
    }
    std::cout << summary_text(reported.summary);
    if (sources[i].skipped > 0) std::cout << counted(sources[i].skipped, "row") << " skipped\n";
  }
  if (report.comparison) std::cout << comparison_text(*report.comparison);
}

std::string one_line(const Json& json) { return json.dump(); }

/// The members of one population, without the braces around them; a line per block, so that a
/// million of them are never in memory as JSON.
void print_population_json(const ReportedPopulation& reported, const ReadPopulation& source,
                           const PopulationOptions& options) {
  std::cout << "\"name\": " << one_line(reported.population.name)
            << ",\n\"box\": " << one_line(source.box) << ",\n\"blocks\": [";
  for (std::size_t i = 0; i < reported.population.blocks.size(); ++i) {
    Json json = measured_block_json(reported.population.blocks[i], options.limits);
    for (const auto& [key, value] : source.surfaces[i].items()) {
      key == "indices" ? json[key].update(value) : void(json[key] = value);
    }
    std::cout << (i > 0 ? ",\n" : "\n") << one_line(json);
  }
  std::cout << "\n],\n\"population\": " << one_line(shares_json(reported.summary))
            << ",\n\"size\": " << one_line(size_json(reported.summary))
            << ",\n\"size_and_shape\": " << one_line(size_and_shape_json(reported.summary))
            << ",\n\"c40\": " << one_line(reported.summary.c40)
            << ",\n\"skipped\": " << source.skipped << ",\n\"notes\": " << one_line(reported.notes);
}

void print_json(const PopulationReport& report, const std::vector<ReadPopulation>& sources) {
  std::cout << "{\n";
  print_population_json(report.populations.front(), sources.front(), report.options);
  std::cout << ",\n\"formulas\": " << one_line(formulas_json());
  if (report.comparison) {
    std::cout << ",\n\"against\": {\n";
    print_population_json(report.populations.back(), sources.back(), report.options);
    std::cout << "\n},\n\"comparison\": " << one_line(comparison_json(*report.comparison));
  }
  std::cout << "\n}\n";
}

/// A file that is in both populations makes them alike.
void note_shared_files(std::vector<ReadPopulation>& sources) {
  ReportedPopulation& second = sources[1].reported;
  for (const InputFile& a : sources[0].reported.inputs) {
    for (const InputFile& b : second.inputs) {
      if (a.sha256 != b.sha256) continue;
      second.notes.push_back("both populations hold the same file, " + a.file +
                             (a.file == b.file ? "" : " and " + b.file));
      sources[1].said += printable(second.population.name + ": " + second.notes.back()) + "\n";
    }
  }
}

/// An option that changes nothing here was meant for something: it is refused.
void check_options_apply(const ClassifyArgs& args, const CLI::App& command) {
  const auto given = [&](const char* option) { return command.count(option) > 0; };
  const auto any = [](const std::vector<std::string>& inputs, bool library) {
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const std::string& input) { return is_library(input) == library; });
  };
  const auto need = [&](const char* option, bool applies, const char* reason) {
    if (given(option) && !applies) throw CLI::ValidationError(option, reason);
  };
  const auto names = [&](const char* scheme) {
    const std::vector<std::string> schemes = schemes_from(args.schemes);
    return std::count(schemes.begin(), schemes.end(), scheme) > 0;
  };
  need("--output", !args.output.empty(), "names no folder");
  need("--replace", given("--output"), "applies to the folder of --output; add --output");
  for (const auto& [option, value] :
       {std::pair{"--columns", &args.first.columns}, std::pair{"--units", &args.first.units},
        std::pair{"--against-columns", &args.against.columns},
        std::pair{"--against-units", &args.against.units}}) {
    need(option, !value->empty(), "is empty");
  }
  for (const char* option : {"--columns", "--units"}) {
    need(option, any(args.first.inputs, false) || any(args.against.inputs, false),
         "is for tables, and every input is a library, whose axes are in metres");
  }
  for (const char* option : {"--against-columns", "--against-units"}) {
    need(option, any(args.against.inputs, false), "is for tables, and --against names none");
  }
  need("--roundness", any(args.first.inputs, true) || any(args.against.inputs, true),
       "is measured on the surface of a library's blocks, and no input is a library");
  need("--roundness", args.json, "is printed with --json only");
  need("--erdogan-limit", args.json || names("erdogan"), "is for the scheme erdogan: add --scheme");
  need("--thirds", args.json || !args.output.empty() || names("sneed-folk"),
       "is for the scheme sneed-folk: add --scheme");
}

void check_has_blocks(const ReadPopulation& source) {
  if (!source.reported.population.blocks.empty()) return;
  throw InputError(source.reported.inputs.front().file + ": there is no block in it to classify");
}

void classify(const ClassifyArgs& args) {
  PopulationReport report;
  report.options = {.size = args.size == "I" ? SizeMeasure::kIntermediate : SizeMeasure::kMean,
                    .seed = args.seed,
                    .schemes = schemes_from(args.schemes),
                    .limits = args.limits};
  std::optional<OutputFolder> folder;
  if (!args.output.empty())
    folder.emplace(args.output, population_folder(args.output), args.replace);
  std::vector<ReadPopulation> sources;
  sources.push_back(read_population(args.first, args.reading));
  if (!args.against.inputs.empty()) {
    PopulationFiles second = args.against;
    if (second.columns.empty()) second.columns = args.first.columns;
    if (second.units.empty()) second.units = args.first.units;
    sources.push_back(read_population(second, args.reading));
    note_shared_files(sources);
  }
  for (ReadPopulation& source : sources) {
    check_has_blocks(source);
    source.reported.summary = summarise_population(source.reported.population, report.options);
    report.populations.push_back(std::move(source.reported));
  }
  if (report.populations.size() > 1) {
    Population &a = report.populations[0].population, &b = report.populations[1].population;
    if (a.name == b.name) {  // the same file name in two folders
      a.name += " (1)";
      b.name += " (2)";
    }
    report.comparison = compare_populations(a, b, report.options);
  }
  if (folder) {
    write_population_report(report, folder->temporary());
    folder->commit();
  }
  // Only now, so that a failure is the first thing said.
  for (const ReadPopulation& source : sources) std::cerr << source.said;
  args.json ? print_json(report, sources) : print_tables(report, sources);
  if (!args.output.empty() && !args.json) {
    std::cout << "\nReport: "
              << printable((std::filesystem::path(args.output) / "report.html").string()) << "\n";
  }
}

}  // namespace

void add_classify(CLI::App& app) {
  const auto args = std::make_shared<ClassifyArgs>();
  CLI::App* command = app.add_subcommand(
      "classify", "Give blocks their shape classes, from libraries or tables of L, I, S");
  command
      ->add_option("inputs", args->first.inputs,
                   "Block libraries, or text tables of tape-measured axes (csv, tsv, txt); several "
                   "are one population")
      ->required()
      ->type_name("LIB|CSV");
  command
      ->add_option("--against", args->against.inputs,
                   "A second population to compare with: libraries or tables")
      ->type_name("LIB|CSV");
  std::string known;
  for (const std::string& name : scheme_names()) known += name + ", ";
  command->add_option("--scheme", args->schemes, "One or more of " + known + "or all")
      ->type_name("NAME,..")
      ->capture_default_str();
  command
      ->add_option("--box", args->reading.box,
                   "Box whose sides are L, I, S of a library's blocks: smallest volume, along the "
                   "principal axes of inertia, longest Feret as by callipers, or PCA of the hull's "
                   "corners")
      ->check(CLI::IsMember({"smallest", "inertia", "feret", "pca"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--axis-error", args->reading.axis_error,
                   "Error of the axes, m; default: 0.05 for a table (tape), twice the "
                   "deviation from the scan for a library")
      ->check(within(kAxisError))
      ->type_name("M");
  command->add_flag("--thirds", args->limits.sneed_folk_thirds,
                    "Limits 1/3 and 2/3 for the second letter of Sneed & Folk, not 0.33 and 0.67");
  command
      ->add_option("--erdogan-limit", args->limits.erdogan_limit,
                   "Ratio of axes from which one counts as longer, for the scheme erdogan")
      ->check(within(kErdoganLimit))
      ->type_name("RATIO")
      ->capture_default_str();
  command
      ->add_option("--roundness", args->reading.roundness_edge,
                   "With --json: Wadell roundness of a library's blocks, on their surface cut anew "
                   "into triangles with edges of so many m")
      ->check(within(kBlockLength))
      ->type_name("M");
  command
      ->add_option("--columns", args->first.columns,
                   "Columns of a table, by name or number from 1; also mass=.. and name=..")
      ->type_name("L=..,I=..,S=..")
      ->capture_default_str();
  command
      ->add_option(
          "--units", args->first.units,
          "Length unit of a table: m, cm, mm, um, km, in, ft, or metres per unit; default: "
          "from its header, otherwise m")
      ->type_name("UNIT");
  command
      ->add_option("--against-columns", args->against.columns,
                   "Columns of the second population's tables; default: the same")
      ->type_name("L=..,I=..,S=..");
  command
      ->add_option("--against-units", args->against.units,
                   "Length unit of the second population's tables; default: the same")
      ->type_name("UNIT");
  command
      ->add_option(
          "--size", args->size,
          "Size of a block in size distributions: I, the sieve axis, or mean, (L I S)^(1/3)")
      ->check(CLI::IsMember({"I", "mean"}))
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--seed", args->seed, "Seed of the random samples behind p-values of fits")
      ->check(whole_number())
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("-o,--output", args->output,
                   "Folder for report.html, tables (csv) and diagrams (svg)")
      ->type_name("DIR");
  command->add_flag("--replace", args->replace, "Replace an existing report in the folder");
  command->add_flag("--json", args->json, "Print as JSON");
  command->footer(
      "Shares come with the 95 % interval of Wilson: what a sample of this size says "
      "about the deposit.\nExamples:\n  clast classify blocks.h5\n"
      "  clast classify talus.csv --columns L=5,I=6,S=7,mass=4 --units cm --scheme zingg\n"
      "  clast classify talus.csv --against blocks.h5 -o classes");
  command->callback([args, command] {
    args->reading.box_given = command->count("--box") > 0;
    args->reading.surfaces = args->json;
    check_usage([&] { args->limits.check(); });
    check_options_apply(*args, *command);
    classify(*args);
  });
}

}  // namespace clast
