#include "app/population_reading.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/text_table.hpp"
#include "classify/certainty.hpp"
#include "classify/dimension_table.hpp"
#include "classify/population_notes.hpp"
#include "core/digest.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"
#include "library/block_library.hpp"
#include "library/unscaled.hpp"
#include "report/json/block_json.hpp"

namespace clast {

namespace {

constexpr std::size_t kMostNotes = 20;  // on the terminal, per input

using Json = nlohmann::ordered_json;

/// True for the signature every HDF5 file begins with.
bool is_hdf5(const std::string& path) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return false;  // a pipe would be waited for
  std::ifstream file(path, std::ios::binary);
  std::string begin(8, '\0');
  return file.read(begin.data(), 8) && begin == "\x89HDF\r\n\x1a\n";
}

DimensionColumns columns_from(const std::string& text, const std::string& units) {
  DimensionColumns columns;
  if (!units.empty()) columns.units = length_unit(units);
  std::map<std::string, std::string> quantities, given;  // by each other
  for (const std::string& item : split_list(text)) {
    const std::size_t equals = item.find('=');
    const std::string quantity = item.substr(0, equals);
    const std::string column = equals == std::string::npos ? "" : item.substr(equals + 1);
    const bool axis = quantity == "L" || quantity == "I" || quantity == "S";
    if (column.empty() || (!axis && quantity != "mass" && quantity != "name")) {
      throw CLI::ValidationError("--columns", "\"" + item +
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

/// What only a whole surface shows.
Json surface_json(const Block& block, const Axes& axes, double roundness_edge) {
  Json json = {{"indices", block_indices(block, axes)}, {"equilibria", equilibria_json(block)}};
  if (roundness_edge > 0.0) json["roundness"] = roundness_json(block, roundness_edge);
  return json;
}

void add_library(ReadPopulation& source, const BlockReading& reading, const std::string& path) {
  const BlockLibrary library = BlockLibrary::read(path);
  for (const Block& block : library.blocks()) {
    std::vector<Axes> by_box;
    for (const BoxConvention convention : kBoxConventions) {
      const Vec3 sides = block_box(block, convention).lengths;
      by_box.push_back({sides[0], sides[1], sides[2]});
    }
    const Axes axes = by_box[static_cast<std::size_t>(box_convention(reading.box))];
    MeasuredBlock measured = measured_block(as_utf8(block.id), axes);
    measured.unscaled = is_unscaled(block);
    if (!measured.unscaled) measured.mass = block.mass.mass;
    measured.by_box = std::move(by_box);
    // The scan's extents are within twice the deviation of the block's.
    measured.axis_error = reading.axis_error && !measured.unscaled
                              ? *reading.axis_error
                              : 2.0 * block.deviation.hausdorff;
    source.reported.population.blocks.push_back(std::move(measured));
    // An edge in metres has no length on a block without any.
    const double edge = is_unscaled(block) ? 0.0 : reading.roundness_edge.value_or(0.0);
    source.surfaces.push_back(reading.surfaces ? surface_json(block, axes, edge) : Json());
  }
}

/// What is said of a table on the terminal: its first notes and how many rows they are about.
std::string notes_text(const std::string& input, const DimensionTable& table) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostNotes, table.notes.size()); ++i) {
    text += shown(input + ": " + table.notes[i]) + "\n";
  }
  if (table.notes.size() > kMostNotes) {
    text += printable(input) + ": and " + std::to_string(table.notes.size() - kMostNotes) +
            " more notes\n";
  }
  if (table.skipped + table.sorted + table.unweighed > 0) {
    text += printable(input) + ": " + counted(table.blocks.size(), "row") + " used, " +
            std::to_string(table.skipped) + " skipped, " + std::to_string(table.sorted) +
            " sorted, " + std::to_string(table.unweighed) + " without a usable mass\n";
  }
  return text;
}

/// Rows without a name of their own are told apart by `stem`, where there is one.
void add_table(ReadPopulation& source, const BlockReading& reading, const std::string& path,
               const DimensionColumns& columns, const std::string& stem) {
  if (reading.box_given) {
    throw CLI::ValidationError(
        "--box",
        path + " is a table: its axes are what was measured, and no box can be put around them");
  }
  DimensionTable table = read_dimension_table(path, columns);
  for (MeasuredBlock& block : table.blocks) {
    if (!stem.empty() && block.name.starts_with("row ")) block.name = stem + " " + block.name;
    block.axis_error = reading.axis_error.value_or(kTapeError);
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

}  // namespace

bool is_library(const std::string& path) {
  return is_hdf5(path) || path.ends_with(".h5") || path.ends_with(".hdf5");
}

ReadPopulation read_population(const PopulationFiles& files, const BlockReading& reading) {
  const DimensionColumns columns = columns_from(files.columns, files.units);
  const std::vector<std::string>& inputs = files.inputs;
  ReadPopulation source;
  ReportedPopulation& reported = source.reported;
  bool tables = false, libraries = false;
  for (const std::string& input : inputs) {
    const std::string stem = as_utf8(std::filesystem::path(input).stem().string());
    if (is_library(input)) {
      libraries = true;
      source.surfaces.resize(reported.population.blocks.size());
      add_library(source, reading, input);
    } else {
      tables = true;
      add_table(source, reading, input, columns, inputs.size() > 1 ? stem : std::string());
    }
    reported.population.name += (reported.population.name.empty() ? "" : " + ") + stem;
    reported.inputs.push_back({as_utf8(input), sha256_of_file(input)});
  }
  source.surfaces.resize(reported.population.blocks.size());
  const std::string box_words = "sides of the " + reading.box + " box of the rounded body";
  source.box = libraries ? reading.box : "as measured";
  reported.measured = libraries && tables ? box_words + ", or as measured"
                      : libraries         ? box_words
                                          : "as measured";
  if (libraries) reported.reading.box = reading.box;
  if (tables) reported.reading.columns = files.columns;
  if (tables && !files.units.empty()) reported.reading.units = files.units;
  reported.reading.axis_error = reading.axis_error;
  std::vector<std::string> notes = same_file_notes(reported.inputs);
  for (std::string& note : population_notes(reported.population.blocks)) {
    notes.push_back(std::move(note));
  }
  for (const std::string& note : notes) {
    reported.notes.push_back(note);
    source.said += shown(reported.population.name + ": " + note) + "\n";
  }
  return source;
}

}  // namespace clast
