#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/block_report.hpp"
#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/text_table.hpp"
#include "classify/dimension_table.hpp"
#include "classify/population.hpp"
#include "library/block_library.hpp"

namespace clast {

namespace {

const std::vector<std::string> kSchemes = {"sneed-folk", "zingg", "garcia"};

struct ClassifyArgs {
  std::string input;
  std::string scheme;
  std::string columns = "L=L,I=I,S=S";
  std::string units = "m";
  std::string box = "smallest";
  bool box_given = false;
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

DimensionColumns columns_from(const ClassifyArgs& args) {
  DimensionColumns columns;
  columns.unit = length_unit(args.units);
  for (const std::string& piece : split_list(args.columns)) {
    const std::size_t equals = piece.find('=');
    const std::string axis = piece.substr(0, equals);
    const std::string column = equals == std::string::npos ? "" : piece.substr(equals + 1);
    if (column.empty() || (axis != "L" && axis != "I" && axis != "S")) {
      throw CLI::ValidationError("--columns", "\"" + piece +
                                                  "\" is not understood; expected something like "
                                                  "L=5,I=6,S=7 or L=length,I=width,S=height");
    }
    (axis == "L" ? columns.L : axis == "I" ? columns.I : columns.S) = column;
  }
  return columns;
}

bool is_library(const ClassifyArgs& args) {
  return is_hdf5(args.input) || named_as_library(args.input);
}

DimensionTable read_blocks(const ClassifyArgs& args) {
  if (!is_library(args)) {
    if (args.box_given) {
      throw CLI::ValidationError(
          "--box", args.input +
                       " is a table: its axes are what was measured, and no box can be "
                       "put around them");
    }
    return read_dimension_table(args.input, columns_from(args));
  }
  DimensionTable table;
  const BlockLibrary library = BlockLibrary::read(args.input);
  for (const Block& block : library.blocks()) {
    const Vec3 sides = block_box(block, box_convention(args.box)).lengths;
    table.blocks.push_back({block.id, {sides[0], sides[1], sides[2]}});
  }
  return table;
}

std::string percent(double share) { return with_decimals(100.0 * share, 1); }

void print_tables(const DimensionTable& measured, const std::vector<std::string>& schemes,
                  const std::vector<Axes>& axes) {
  TextTable blocks{{"block", "L m", "I m", "S m", "s_c"}, {}};
  blocks.headings.insert(blocks.headings.end(), schemes.begin(), schemes.end());
  for (const MeasuredBlock& block : measured.blocks) {
    blocks.rows.push_back({block.name, rounded(block.axes.L), rounded(block.axes.I),
                           rounded(block.axes.S), rounded(elongation_s_c(block.axes), 3)});
    for (const std::string& scheme : schemes) {
      blocks.rows.back().push_back(shape_class(scheme, block.axes));
    }
  }
  std::cout << blocks.text();
  for (const std::string& scheme : schemes) {
    TextTable shares{{scheme, "blocks", "share %", "95 % from", "to"}, {}};
    for (const ClassShare& share : class_shares(axes, scheme)) {
      shares.rows.push_back({share.name, std::to_string(share.count), percent(share.share),
                             percent(share.low), percent(share.high)});
    }
    std::cout << "\n" << shares.text();
  }
}

void print_json(const DimensionTable& measured, const std::vector<std::string>& schemes,
                const std::vector<Axes>& axes, const std::string& box) {
  using Json = nlohmann::ordered_json;
  Json blocks = Json::array();
  for (const MeasuredBlock& block : measured.blocks) {
    Json json = {{"id", block.name},
                 {"box_m", {block.axes.L, block.axes.I, block.axes.S}},
                 {"s_c", elongation_s_c(block.axes)}};
    for (const std::string& scheme : schemes) {
      const std::string key = scheme == "garcia"  ? "shape"
                              : scheme == "zingg" ? "zingg"
                                                  : "sneed_folk";
      json[key] = shape_class(scheme, block.axes);
    }
    json["indices"] = form_indices(block.axes);
    blocks.push_back(json);
  }
  Json population = Json::object();
  for (const std::string& scheme : schemes) {
    population[scheme] = Json::array();
    for (const ClassShare& share : class_shares(axes, scheme)) {
      population[scheme].push_back({{"class", share.name},
                                    {"blocks", share.count},
                                    {"share", share.share},
                                    {"low", share.low},
                                    {"high", share.high}});
    }
  }
  const Json all = {
      {"box", box}, {"blocks", blocks}, {"population", population}, {"notes", measured.notes}};
  std::cout << all.dump(2) << "\n";
}

void classify(const ClassifyArgs& args) {
  const DimensionTable measured = read_blocks(args);
  std::vector<Axes> axes;
  for (const MeasuredBlock& block : measured.blocks) axes.push_back(block.axes);
  const std::vector<std::string> schemes =
      args.scheme.empty() ? kSchemes : std::vector<std::string>{args.scheme};
  for (const std::string& note : measured.notes) std::cerr << args.input << ": " << note << "\n";
  const std::string box = is_library(args) ? args.box : "as measured";
  if (args.json) {
    print_json(measured, schemes, axes, box);
    return;
  }
  std::cout << "L, I, S: "
            << (is_library(args) ? "sides of the " + box + " box of the rounded body" : box)
            << "\n\n";
  print_tables(measured, schemes, axes);
}

}  // namespace

void add_classify(CLI::App& app) {
  const auto args = std::make_shared<ClassifyArgs>();
  CLI::App* command = app.add_subcommand(
      "classify", "Give blocks their shape classes, from a library or a table of L, I, S");
  command
      ->add_option("input", args->input,
                   "Block library, or a text table of tape-measured axes (csv, tsv, txt)")
      ->required()
      ->type_name("LIB|CSV");
  command->add_option("--scheme", args->scheme, "sneed-folk, zingg or garcia; default: all three")
      ->check(CLI::IsMember(kSchemes))
      ->type_name("NAME");
  command->add_option("--columns", args->columns, "Columns of a table, by name or number from 1")
      ->type_name("L=..,I=..,S=..")
      ->capture_default_str();
  command
      ->add_option("--units", args->units,
                   "Length unit of a table: m, cm, mm, km, in, ft, or metres per unit")
      ->type_name("UNIT")
      ->capture_default_str();
  command
      ->add_option("--box", args->box,
                   "Box whose sides are L, I, S of a library's blocks: smallest volume, along the "
                   "principal axes of inertia, longest Feret as by callipers, or PCA of the hull's "
                   "corners")
      ->check(CLI::IsMember({"smallest", "inertia", "feret", "pca"}))
      ->type_name("NAME")
      ->capture_default_str();
  command->add_flag("--json", args->json, "Print as JSON");
  command->footer(
      "Shares come with the 95 % interval of Wilson: what a sample of this size says "
      "about the deposit.\nExamples:\n  clast classify blocks.h5\n"
      "  clast classify talus.csv --columns L=5,I=6,S=7 --units cm --scheme zingg");
  command->callback([args, command] {
    args->box_given = command->count("--box") > 0;
    classify(*args);
  });
}

}  // namespace clast
