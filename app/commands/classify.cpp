#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>

#include "app/block_report.hpp"
#include "app/classify_report.hpp"
#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "classify/certainty.hpp"
#include "classify/dimension_table.hpp"
#include "core/error.hpp"
#include "library/block_library.hpp"

namespace clast {

namespace {

struct ClassifyArgs {
  std::string input, other;
  std::string schemes = "sneed-folk,zingg,garcia";
  std::string columns = "L=L,I=I,S=S";
  std::string units = "m";
  std::string box = "smallest";
  bool box_given = false;
  double axis_error = -1.0;
  double roundness_edge = 0.0;
  SchemeOptions options;
  bool json = false;
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
    try {
      class_names(scheme);
    } catch (const InputError& error) {
      throw CLI::ValidationError("--scheme", error.what());
    }
  }
  return schemes;
}

DimensionColumns columns_from(const ClassifyArgs& args) {
  DimensionColumns columns;
  columns.unit = length_unit(args.units);
  for (const std::string& piece : split_list(args.columns)) {
    const std::size_t equals = piece.find('=');
    const std::string name = piece.substr(0, equals);
    const std::string column = equals == std::string::npos ? "" : piece.substr(equals + 1);
    std::string* const wanted = name == "L"      ? &columns.L
                                : name == "I"    ? &columns.I
                                : name == "S"    ? &columns.S
                                : name == "mass" ? &columns.mass
                                                 : nullptr;
    if (column.empty() || wanted == nullptr) {
      throw CLI::ValidationError("--columns", "\"" + piece +
                                                  "\" is not understood; expected something like "
                                                  "L=5,I=6,S=7,mass=4 or L=length,I=width,"
                                                  "S=height");
    }
    *wanted = column;
  }
  return columns;
}

/// What only a whole surface tells.
nlohmann::ordered_json surface_json(const Block& block, const Axes& axes, double roundness_edge) {
  nlohmann::ordered_json json = {{"indices", block_indices(block, axes)},
                                 {"equilibria", equilibria_json(block)}};
  if (roundness_edge > 0.0) json["roundness"] = roundness_json(block, roundness_edge);
  return json;
}

void add_library(Classification& all, const ClassifyArgs& args, const std::string& path) {
  all.box = args.box;
  const BlockLibrary library = BlockLibrary::read(path);
  for (const Block& block : library.blocks()) {
    const Vec3 sides = block_box(block, box_convention(args.box)).lengths;
    const Axes axes = {sides[0], sides[1], sides[2]};
    // The scan's extents are within twice the deviation of the block's.
    const double error = args.axis_error >= 0.0 ? args.axis_error : 2.0 * block.deviation.hausdorff;
    all.blocks.push_back({block.id, axes, block.mass.mass, error,
                          args.json ? surface_json(block, axes, args.roundness_edge) : nullptr});
  }
}

void add_table(Classification& all, const ClassifyArgs& args, const std::string& path) {
  if (args.box_given) {
    throw CLI::ValidationError(
        "--box",
        path + " is a table: its axes are what was measured, and no box can be put around them");
  }
  const DimensionTable table = read_dimension_table(path, columns_from(args));
  all.notes = table.notes;
  all.skipped = table.skipped;
  const double error = args.axis_error >= 0.0 ? args.axis_error : kTapeError;
  for (const MeasuredBlock& block : table.blocks) {
    all.blocks.push_back({block.name, block.axes, block.mass, error, nullptr});
  }
}

Classification classification(const ClassifyArgs& args, const std::string& path) {
  Classification all;
  all.schemes = schemes_from(args.schemes);
  all.options = args.options;
  is_library(path) ? add_library(all, args, path) : add_table(all, args, path);
  return all;
}

void say_notes(const std::string& path, const Classification& all) {
  for (const std::string& note : all.notes) std::cerr << path << ": " << note << "\n";
}

void classify(const ClassifyArgs& args) {
  check_usage([&] { args.options.check(); });
  const Classification all = classification(args, args.input);
  std::optional<Classification> other;
  if (!args.other.empty()) {
    other = classification(args, args.other);
    if (all.blocks.empty() || other->blocks.empty()) {
      throw InputError((all.blocks.empty() ? args.input : args.other) +
                       ": there is no block in it to compare");
    }
  }
  say_notes(args.input, all);
  if (other) say_notes(args.other, *other);
  if (args.json) {
    nlohmann::ordered_json json = classification_json(all);
    if (other) json["comparison"] = comparison_json(all, *other);
    std::cout << json.dump(2) << "\n";
    return;
  }
  std::cout << classification_text(all);
  if (!other) return;
  std::cout << "\nagainst " << args.other << " (" << other->blocks.size() << " blocks):\n";
  for (const std::string& line : comparison_lines(all, *other)) std::cout << line << "\n";
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
  command
      ->add_option("--scheme", args->schemes,
                   "One or more of sneed-folk, zingg, garcia, williams, erdogan, blott-pye, "
                   "en-933-4, flakiness, or all")
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
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("M");
  command->add_flag("--thirds", args->options.sneed_folk_thirds,
                    "Limits 1/3 and 2/3 for the second letter of Sneed & Folk, not 0.33 and 0.67");
  command
      ->add_option("--erdogan-limit", args->options.erdogan_limit,
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
      ->add_option("--compare", args->other,
                   "Another library or table, read the same way: is it the same population?")
      ->type_name("LIB|CSV");
  command
      ->add_option("--columns", args->columns,
                   "Columns of a table, by name or number from 1; mass in kg")
      ->type_name("L=..,I=..,S=..,mass=..")
      ->capture_default_str();
  command
      ->add_option("--units", args->units,
                   "Length unit of a table: m, cm, mm, km, in, ft, or metres per unit")
      ->type_name("UNIT")
      ->capture_default_str();
  command->add_flag("--json", args->json, "Print as JSON");
  command->footer(
      "Shares come with the 95 % interval of Wilson: what a sample of this size says "
      "about the deposit.\nExamples:\n  clast classify blocks.h5\n"
      "  clast classify talus.csv --columns L=5,I=6,S=7,mass=4 --units cm --scheme zingg");
  command->callback([args, command] {
    args->box_given = command->count("--box") > 0;
    classify(*args);
  });
}

}  // namespace clast
