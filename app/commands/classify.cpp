#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/block_report.hpp"
#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/population_print.hpp"
#include "app/text_table.hpp"
#include "classify/certainty.hpp"
#include "classify/dimension_table.hpp"
#include "classify/population_notes.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/utf8.hpp"
#include "library/block_library.hpp"
#include "library/unscaled.hpp"
#include "study/population_report.hpp"

namespace clast {

namespace {

constexpr std::size_t kMostPrinted = 1000;  // blocks in a printed table
constexpr std::size_t kMostNotes = 20;      // on the terminal, per input

using Json = nlohmann::ordered_json;

struct ClassifyArgs {
  std::vector<std::string> inputs;
  std::vector<std::string> against;
  std::string schemes = "sneed-folk,zingg,garcia";
  std::string columns = "L=L,I=I,S=S";
  std::string against_columns;
  std::string units;
  std::string against_units;
  std::string box = "smallest";
  bool box_given = false;
  double axis_error = -1.0;
  double roundness_edge = 0.0;
  SchemeOptions limits;
  std::string size = "I";
  std::string output;
  std::uint64_t seed = 1;
  bool json = false;
};

/// A population as it was read, with what only the printed form of it needs.
struct Source {
  ReportedPopulation reported;
  std::vector<Json> surfaces;  ///< of the blocks of libraries, for JSON; null for rows of tables
  std::string box;             ///< convention of the axes
  std::size_t skipped = 0;     ///< rows of tables
  std::string said;            ///< notes for the terminal
};

/// True for the signature every HDF5 file begins with.
bool is_hdf5(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(8, '\0');
  return file.read(begin.data(), 8) && begin == "\x89HDF\r\n\x1a\n";
}

bool is_library(const std::string& path) {
  return is_hdf5(path) || path.ends_with(".h5") || path.ends_with(".hdf5");
}

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

DimensionColumns columns_from(const std::string& text, const std::string& units) {
  DimensionColumns columns;
  if (!units.empty()) columns.unit = length_unit(units);
  std::map<std::string, std::string> quantities, given;  // by each other
  for (const std::string& piece : split_list(text)) {
    const std::size_t equals = piece.find('=');
    const std::string quantity = piece.substr(0, equals);
    const std::string column = equals == std::string::npos ? "" : piece.substr(equals + 1);
    const bool axis = quantity == "L" || quantity == "I" || quantity == "S";
    if (column.empty() || (!axis && quantity != "mass" && quantity != "name")) {
      throw CLI::ValidationError("--columns", "\"" + piece +
                                                  "\" is not understood; expected something like "
                                                  "L=5,I=6,S=7,mass=4 or L=length,I=width,S=height,"
                                                  "name=label");
    }
    if (!given.emplace(quantity, column).second) {
      throw CLI::ValidationError("--columns", quantity + " is given as column " + given[quantity] +
                                                  " and as column " + column);
    }
    if (quantity != "name" && !quantities.emplace(column, quantity).second) {
      throw CLI::ValidationError("--columns", "column " + column + " is given as " +
                                                  quantities[column] + " and as " + quantity);
    }
    if (axis) {
      (quantity == "L" ? columns.L : quantity == "I" ? columns.I : columns.S) = column;
    } else {
      (quantity == "mass" ? columns.mass : columns.name) = column;
    }
  }
  return columns;
}

/// What only a whole surface tells.
Json surface_json(const Block& block, const Axes& axes, double roundness_edge) {
  Json json = {{"indices", block_indices(block, axes)}, {"equilibria", equilibria_json(block)}};
  if (roundness_edge > 0.0) json["roundness"] = roundness_json(block, roundness_edge);
  return json;
}

void add_library(Source& source, const ClassifyArgs& args, const std::string& path) {
  const BlockLibrary library = BlockLibrary::read(path);
  for (const Block& block : library.blocks()) {
    std::vector<Axes> by_box;
    for (const BoxConvention convention : kBoxConventions) {
      const Vec3 sides = block_box(block, convention).lengths;
      by_box.push_back({sides[0], sides[1], sides[2]});
    }
    const Axes axes = by_box[static_cast<std::size_t>(box_convention(args.box))];
    MeasuredBlock measured = measured_block(as_utf8(block.id), axes);
    measured.unscaled = is_unscaled(block);
    if (!measured.unscaled) measured.mass = block.mass.mass;
    measured.by_box = std::move(by_box);
    // The scan's extents are within twice the deviation of the block's.
    measured.axis_error = args.axis_error >= 0.0 && !measured.unscaled
                              ? args.axis_error
                              : 2.0 * block.deviation.hausdorff;
    source.reported.population.blocks.push_back(std::move(measured));
    // An edge in metres has no length on a block without any.
    const double edge = is_unscaled(block) ? 0.0 : args.roundness_edge;
    source.surfaces.push_back(args.json ? surface_json(block, axes, edge) : Json());
  }
}

/// What is said of a table on the terminal: its first notes and how many rows they are about.
std::string notes_text(const std::string& input, const DimensionTable& table) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostNotes, table.notes.size()); ++i) {
    text += input + ": " + table.notes[i] + "\n";
  }
  if (table.notes.size() > kMostNotes) {
    text += input + ": and " + std::to_string(table.notes.size() - kMostNotes) + " more notes\n";
  }
  if (table.skipped + table.sorted + table.unweighed > 0) {
    text += input + ": " + counted(table.blocks.size(), "row") + " used, " +
            std::to_string(table.skipped) + " skipped, " + std::to_string(table.sorted) +
            " sorted, " + std::to_string(table.unweighed) + " without a usable mass\n";
  }
  return text;
}

/// Rows without a name of their own are told apart by `stem`, where there is one.
void add_table(Source& source, const ClassifyArgs& args, const std::string& path,
               const DimensionColumns& columns, const std::string& stem) {
  if (args.box_given) {
    throw CLI::ValidationError(
        "--box",
        path + " is a table: its axes are what was measured, and no box can be put around them");
  }
  DimensionTable table = read_dimension_table(path, columns);
  for (MeasuredBlock& block : table.blocks) {
    if (!stem.empty() && block.name.starts_with("row ")) block.name = stem + " " + block.name;
    block.axis_error = args.axis_error >= 0.0 ? args.axis_error : kTapeError;
    source.reported.population.blocks.push_back(std::move(block));
  }
  for (const std::string& note : table.notes) {
    source.reported.notes.push_back(stem.empty() ? note : stem + ": " + note);
  }
  source.skipped += table.skipped;
  source.said += notes_text(path, table);
}

/// Says it where files are the same, which counts their blocks as often.
std::vector<std::string> same_file_notes(const std::vector<InputFile>& inputs) {
  std::map<std::string, std::vector<std::string>> names;  // by content
  for (const InputFile& input : inputs) names[input.sha256].push_back(input.file);
  std::vector<std::string> notes;
  for (const InputFile& input : inputs) {
    const std::vector<std::string>& same = names[input.sha256];
    if (same.size() < 2) continue;
    std::string all;
    for (const std::string& name : same) all += (all.empty() ? "" : ", ") + name;
    notes.push_back("the same file was given " + std::to_string(same.size()) + " times (" + all +
                    "): its blocks are counted " + std::to_string(same.size()) + " times");
    names[input.sha256].clear();  // said once
  }
  return notes;
}

/// Which files a population is made of, and how to read them.
struct PopulationArgs {
  std::vector<std::string> inputs;
  std::string columns;
  std::string units;
};

/// One population out of several files.
Source read_population(const ClassifyArgs& args, const PopulationArgs& asked) {
  const DimensionColumns columns = columns_from(asked.columns, asked.units);
  const std::vector<std::string>& inputs = asked.inputs;
  Source source;
  ReportedPopulation& reported = source.reported;
  bool tables = false, libraries = false;
  for (const std::string& input : inputs) {
    const std::string stem = as_utf8(std::filesystem::path(input).stem().string());
    if (is_library(input)) {
      libraries = true;
      source.surfaces.resize(reported.population.blocks.size());
      add_library(source, args, input);
    } else {
      tables = true;
      add_table(source, args, input, columns, inputs.size() > 1 ? stem : std::string());
    }
    reported.population.name += (reported.population.name.empty() ? "" : " + ") + stem;
    reported.inputs.push_back({as_utf8(input), sha256_of_file(input)});
  }
  source.surfaces.resize(reported.population.blocks.size());
  const std::string box_words = "sides of the " + args.box + " box of the rounded body";
  source.box = libraries ? args.box : "as measured";
  reported.measured = libraries && tables ? box_words + ", or as measured"
                      : libraries         ? box_words
                                          : "as measured";
  ReadingOptions& reading = reported.reading;
  if (libraries) reading.box = args.box;
  if (tables) reading.columns = asked.columns;
  if (tables && !asked.units.empty()) reading.units = asked.units;
  if (args.axis_error >= 0.0) reading.axis_error = args.axis_error;
  std::vector<std::string> notes = same_file_notes(reported.inputs);
  for (std::string& note : population_notes(reported.population.blocks)) {
    notes.push_back(std::move(note));
  }
  for (const std::string& note : notes) {
    reported.notes.push_back(note);
    source.said += reported.population.name + ": " + note + "\n";
  }
  return source;
}

void print_tables(const PopulationReport& report, const std::vector<Source>& sources) {
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    if (i > 0) std::cout << "\n";
    if (report.populations.size() > 1) std::cout << reported.population.name << "\n";
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
void print_population_json(const ReportedPopulation& reported, const Source& source,
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

void print_json(const PopulationReport& report, const std::vector<Source>& sources) {
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
void note_shared_files(std::vector<Source>& sources) {
  ReportedPopulation& second = sources[1].reported;
  for (const InputFile& a : sources[0].reported.inputs) {
    for (const InputFile& b : second.inputs) {
      if (a.sha256 != b.sha256) continue;
      second.notes.push_back("both populations hold the same file, " + a.file +
                             (a.file == b.file ? "" : " and " + b.file));
      sources[1].said += second.population.name + ": " + second.notes.back() + "\n";
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
  for (const auto& [option, value] :
       {std::pair{"--columns", &args.columns}, std::pair{"--units", &args.units},
        std::pair{"--against-columns", &args.against_columns},
        std::pair{"--against-units", &args.against_units}}) {
    need(option, !value->empty(), "is empty");
  }
  for (const char* option : {"--columns", "--units"}) {
    need(option, any(args.inputs, false) || any(args.against, false),
         "is for tables, and every input is a library, whose axes are in metres");
  }
  for (const char* option : {"--against-columns", "--against-units"}) {
    need(option, any(args.against, false), "is for tables, and --against names none");
  }
  need("--roundness", any(args.inputs, true) || any(args.against, true),
       "is measured on the surface of a library's blocks, and no input is a library");
  need("--roundness", args.json, "is printed with --json only");
  need("--erdogan-limit", args.json || names("erdogan"), "is for the scheme erdogan: add --scheme");
  need("--thirds", args.json || !args.output.empty() || names("sneed-folk"),
       "is for the scheme sneed-folk: add --scheme");
}

void check_has_blocks(const Source& source) {
  if (!source.reported.population.blocks.empty()) return;
  throw InputError(source.reported.inputs.front().file + ": there is no block in it to classify");
}

void classify(const ClassifyArgs& args) {
  PopulationReport report;
  report.options = {.size = args.size == "I" ? SizeMeasure::kIntermediate : SizeMeasure::kMean,
                    .seed = args.seed,
                    .schemes = schemes_from(args.schemes),
                    .limits = args.limits};
  std::vector<Source> sources;
  sources.push_back(read_population(args, {args.inputs, args.columns, args.units}));
  if (!args.against.empty()) {
    sources.push_back(read_population(
        args, {args.against, args.against_columns.empty() ? args.columns : args.against_columns,
               args.against_units.empty() ? args.units : args.against_units}));
    note_shared_files(sources);
  }
  for (Source& source : sources) {
    check_has_blocks(source);
    source.reported.summary = summarised(source.reported.population, report.options);
    report.populations.push_back(std::move(source.reported));
  }
  if (report.populations.size() > 1) {
    Population &a = report.populations[0].population, &b = report.populations[1].population;
    if (a.name == b.name) {  // the same file name in two folders
      a.name += " (1)";
      b.name += " (2)";
    }
    report.comparison = compared(a, b, report.options);
  }
  if (!args.output.empty()) write_population_report(report, args.output);
  // Only now, so that a failure is the first thing said.
  for (const Source& source : sources) std::cerr << source.said;
  args.json ? print_json(report, sources) : print_tables(report, sources);
  if (!args.output.empty() && !args.json) {
    std::cout << "\nReport: " << (std::filesystem::path(args.output) / "report.html").string()
              << "\n";
  }
}

}  // namespace

void add_classify(CLI::App& app) {
  const auto args = std::make_shared<ClassifyArgs>();
  CLI::App* command = app.add_subcommand(
      "classify", "Give blocks their shape classes, from libraries or tables of L, I, S");
  command
      ->add_option("inputs", args->inputs,
                   "Block libraries, or text tables of tape-measured axes (csv, tsv, txt); several "
                   "are one population")
      ->required()
      ->type_name("LIB|CSV");
  command
      ->add_option("--against", args->against,
                   "A second population to compare with: libraries or tables")
      ->type_name("LIB|CSV");
  std::string known;
  for (const std::string& name : scheme_names()) known += name + ", ";
  command->add_option("--scheme", args->schemes, "One or more of " + known + "or all")
      ->type_name("NAME,..")
      ->capture_default_str();
  command
      ->add_option("--box", args->box,
                   "Box whose sides are L, I, S of a library's blocks: smallest volume, along the "
                   "principal axes of inertia, longest Feret as by callipers, or PCA of the hull's "
                   "corners")
      ->check(CLI::IsMember({"smallest", "inertia", "feret", "pca"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--axis-error", args->axis_error,
                   "What the axes are known to, m; default: 0.05 for a table (tape), twice the "
                   "deviation from the scan for a library")
      ->check(number_between(0.0, 1e6))
      ->type_name("M");
  command->add_flag("--thirds", args->limits.sneed_folk_thirds,
                    "Limits 1/3 and 2/3 for the second letter of Sneed & Folk, not 0.33 and 0.67");
  command
      ->add_option("--erdogan-limit", args->limits.erdogan_limit,
                   "Ratio of axes from which one counts as longer, for the scheme erdogan")
      ->type_name("RATIO")
      ->capture_default_str();
  command
      ->add_option("--roundness", args->roundness_edge,
                   "With --json: Wadell roundness of a library's blocks, on their surface cut anew "
                   "into triangles with edges of so many m")
      ->check(positive_number())
      ->type_name("M");
  command
      ->add_option("--columns", args->columns,
                   "Columns of a table, by name or number from 1; also mass=.. and name=..")
      ->type_name("L=..,I=..,S=..")
      ->capture_default_str();
  command
      ->add_option(
          "--units", args->units,
          "Length unit of a table: m, cm, mm, um, km, in, ft, or metres per unit; default: "
          "as its header says, else m")
      ->type_name("UNIT");
  command
      ->add_option("--against-columns", args->against_columns,
                   "Columns of the second population's tables; default: the same")
      ->type_name("L=..,I=..,S=..");
  command
      ->add_option("--against-units", args->against_units,
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
  command->add_flag("--json", args->json, "Print as JSON");
  command->footer(
      "Shares come with the 95 % interval of Wilson: what a sample of this size says "
      "about the deposit.\nExamples:\n  clast classify blocks.h5\n"
      "  clast classify talus.csv --columns L=5,I=6,S=7,mass=4 --units cm --scheme zingg\n"
      "  clast classify talus.csv --against blocks.h5 -o classes");
  command->callback([args, command] {
    args->box_given = command->count("--box") > 0;
    check_usage([&] { args->limits.check(); });
    check_options_apply(*args, *command);
    classify(*args);
  });
}

}  // namespace clast
