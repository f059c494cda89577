#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/population_print.hpp"
#include "app/text_table.hpp"
#include "classify/dimension_table.hpp"
#include "classify/population.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "library/block_library.hpp"
#include "study/population_report.hpp"

namespace clast {

namespace {

constexpr std::size_t kMostPrinted = 1000;  // blocks in a printed table
constexpr std::size_t kMostNotes = 20;      // on the terminal, per input

struct ClassifyArgs {
  std::vector<std::string> inputs;
  std::vector<std::string> against;
  std::string scheme;
  std::string columns = "L=L,I=I,S=S";
  std::string against_columns;
  std::string units;
  std::string against_units;
  std::string size = "I";
  std::string output;
  std::uint64_t seed = 1;
  bool json = false;
};

/// True for the signature every HDF5 file begins with.
bool is_hdf5(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(8, '\0');
  return file.read(begin.data(), 8) && begin == "\x89HDF\r\n\x1a\n";
}

bool named_as_library(const std::string& path) {
  return path.ends_with(".h5") || path.ends_with(".hdf5");
}

DimensionColumns columns_from(const std::string& text, const std::string& units) {
  DimensionColumns columns;
  if (!units.empty()) columns.unit = length_unit(units);
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
    if (axis) {
      (quantity == "L" ? columns.L : quantity == "I" ? columns.I : columns.S) = column;
    } else {
      (quantity == "mass" ? columns.mass : columns.name) = column;
    }
  }
  return columns;
}

DimensionTable read_blocks(const std::string& input, const DimensionColumns& columns) {
  if (!is_hdf5(input) && !named_as_library(input)) return read_dimension_table(input, columns);
  DimensionTable table;
  const BlockLibrary library = BlockLibrary::read(input);
  for (const Block& block : library.blocks()) {
    table.blocks.push_back(measured_block(block.id, block.axes(), block.mass.mass));
  }
  if (table.blocks.empty()) throw InputError(input + ": the library holds no blocks");
  return table;
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

/// One population out of several files; rows without a name of their own are told apart by file.
ReportedPopulation read_population(const std::vector<std::string>& inputs,
                                   const DimensionColumns& columns,
                                   std::vector<std::string>& said) {
  ReportedPopulation reported;
  bool tables = false, libraries = false;
  for (const std::string& input : inputs) {
    DimensionTable table = read_blocks(input, columns);
    const std::string stem = std::filesystem::path(input).stem().string();
    (is_hdf5(input) ? libraries : tables) = true;
    reported.population.name += (reported.population.name.empty() ? "" : " + ") + stem;
    for (MeasuredBlock& block : table.blocks) {
      if (inputs.size() > 1 && block.name.starts_with("row ")) block.name = stem + " " + block.name;
      reported.population.blocks.push_back(std::move(block));
    }
    for (const std::string& note : table.notes) {
      reported.notes.push_back(inputs.size() > 1 ? stem + ": " + note : note);
    }
    said.push_back(notes_text(input, table));
    reported.inputs.push_back(input + " " + sha256_of_file(input));
  }
  reported.measured =
      libraries ? "sides of the smallest box of the rounded block" : "as in the table";
  if (libraries && tables) reported.measured += ", or as in the table";
  return reported;
}

void print_tables(const PopulationReport& report, const std::vector<std::string>& schemes) {
  for (const ReportedPopulation& reported : report.populations) {
    if (report.populations.size() > 1) {
      std::cout << (&reported == &report.populations.front() ? "" : "\n")
                << reported.population.name << "\n";
    }
    if (reported.population.blocks.size() > kMostPrinted) {
      std::cout << reported.population.blocks.size()
                << " blocks; -o DIR writes them to classes.csv, --json prints them\n";
    } else {
      TextTable blocks{{"block", "L m", "I m", "S m", "s_c"}, {}};
      blocks.headings.insert(blocks.headings.end(), schemes.begin(), schemes.end());
      for (const MeasuredBlock& block : reported.population.blocks) {
        blocks.rows.push_back({block.name, rounded(block.axes.L), rounded(block.axes.I),
                               rounded(block.axes.S),
                               rounded(elongation_s_c(block.as_written), 3)});
        for (const std::string& scheme : schemes) {
          blocks.rows.back().push_back(shape_class(scheme, block.as_written));
        }
      }
      std::cout << blocks.text();
    }
    std::cout << summary_text(reported.summary);
  }
  if (report.comparison) std::cout << comparison_text(*report.comparison);
}

nlohmann::ordered_json block_json(const MeasuredBlock& block,
                                  const std::vector<std::string>& schemes) {
  nlohmann::ordered_json json = {{"id", block.name},
                                 {"box_m", {block.axes.L, block.axes.I, block.axes.S}},
                                 {"s_c", elongation_s_c(block.as_written)}};
  if (block.mass) json["mass_kg"] = *block.mass;
  for (const std::string& scheme : schemes) {
    json[class_column(scheme)] = shape_class(scheme, block.as_written);
  }
  json["indices"] = form_indices(block.as_written);
  return json;
}

/// The members of one population, without the braces around them; a line per block, so that a
/// million of them are never in memory as JSON.
void print_population_json(const ReportedPopulation& reported,
                           const std::vector<std::string>& schemes) {
  const auto text = [](const nlohmann::ordered_json& json) {
    // Names may hold bytes that are not UTF-8.
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  };
  std::cout << "\"name\": " << text(reported.population.name) << ",\n\"blocks\": [";
  const char* separator = "\n";
  for (const MeasuredBlock& block : reported.population.blocks) {
    std::cout << separator << text(block_json(block, schemes));
    separator = ",\n";
  }
  std::cout << "\n],\n\"population\": " << text(shares_json(reported.summary))
            << ",\n\"size\": " << text(size_json(reported.summary))
            << ",\n\"size_and_shape\": " << text(size_and_shape_json(reported.summary))
            << ",\n\"notes\": " << text(reported.notes);
}

void print_json(const PopulationReport& report, const std::vector<std::string>& schemes) {
  std::cout << "{\n";
  print_population_json(report.populations.front(), schemes);
  if (report.comparison) {
    std::cout << ",\n\"against\": {\n";
    print_population_json(report.populations.back(), schemes);
    std::cout << "\n},\n\"comparison\": "
              << comparison_json(*report.comparison)
                     .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  std::cout << "\n}\n";
}

void classify(const ClassifyArgs& args) {
  PopulationReport report;
  if (!args.scheme.empty()) report.options.schemes = {args.scheme};
  report.options.size = args.size == "I" ? SizeMeasure::kIntermediate : SizeMeasure::kMean;
  report.options.seed = args.seed;
  const DimensionColumns columns = columns_from(args.columns, args.units);
  const DimensionColumns against_columns =
      columns_from(args.against_columns.empty() ? args.columns : args.against_columns,
                   args.against_units.empty() ? args.units : args.against_units);

  std::vector<std::string> said;
  report.populations.push_back(read_population(args.inputs, columns, said));
  if (!args.against.empty()) {
    report.populations.push_back(read_population(args.against, against_columns, said));
    Population &a = report.populations[0].population, &b = report.populations[1].population;
    if (a.name == b.name) {  // the same file name in two folders
      a.name += " (1)";
      b.name += " (2)";
    }
    report.comparison = compared(a, b, report.options);
  }
  for (ReportedPopulation& reported : report.populations) {
    reported.summary = summarised(reported.population, report.options);
  }
  const std::vector<std::string> schemes =
      args.scheme.empty() ? scheme_names() : std::vector<std::string>{args.scheme};
  if (!args.output.empty()) write_population_report(report, args.output);
  // Only now, so that a failure is the first thing said.
  for (const std::string& notes : said) std::cerr << notes;
  args.json ? print_json(report, schemes) : print_tables(report, schemes);
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
  for (const std::string& name : scheme_names()) known += (known.empty() ? "" : ", ") + name;
  command->add_option("--scheme", args->scheme, known + "; default: all")
      ->check(CLI::IsMember(scheme_names()))
      ->type_name("NAME");
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
  command->callback([args] { classify(*args); });
}

}  // namespace clast
