#include "report/population_reading.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "classify/certainty.hpp"
#include "classify/population_notes.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/digest.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "library/block_library.hpp"
#include "library/block_measures.hpp"
#include "library/block_ranges.hpp"
#include "library/deposit_observations.hpp"
#include "library/unscaled.hpp"

namespace clast {

namespace {

constexpr std::size_t kMaxBriefNotes = 20;  // of each table

/// True for the signature every HDF5 file begins with.
bool is_hdf5(const std::string& path) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return false;  // a pipe would be waited for
  std::ifstream file(path, std::ios::binary);
  std::string begin(8, '\0');
  return file.read(begin.data(), 8) && begin == "\x89HDF\r\n\x1a\n";
}

SurfaceMeasures surface_measures(const Block& block, const Axes& axes,
                                 const std::optional<double>& roundness_edge) {
  SurfaceMeasures measures{block_indices(block, axes), block_equilibria(block), {}};
  // An edge in metres has no length on a block without any.
  if (roundness_edge && !is_unscaled(block)) {
    measures.roundness = block_roundness(block, *roundness_edge);
  }
  return measures;
}

/// Converts the intervals of the sides of the smallest box to those of another box.
DepositObservation observation_by_box(DepositObservation seen, const Axes& smallest,
                                      const Axes& axes) {
  for (Axes* limit : {&seen.lower_axes, &seen.upper_axes}) {
    *limit = {limit->L * axes.L / smallest.L, limit->I * axes.I / smallest.I,
              limit->S * axes.S / smallest.S};
  }
  return seen;
}

void add_library(ReportedPopulation& reported, const BlockMeasuringOptions& reading,
                 const std::string& path) {
  const BlockLibrary library = BlockLibrary::read(path);
  const std::vector<std::optional<DepositObservation>> observations =
      make_deposit_observations(library.blocks());
  for (std::size_t i = 0; i < library.blocks().size(); ++i) {
    const Block& block = library.blocks()[i];
    std::vector<Axes> axes_by_box;
    for (const BoxConvention convention : kBoxConventions) {
      const Vec3 sides = block_box(block, convention).lengths;
      axes_by_box.push_back({sides[0], sides[1], sides[2]});
    }
    const Axes axes = axes_by_box[static_cast<std::size_t>(parse_box_convention(reading.box))];
    MeasuredBlock measured = make_measured_block(to_utf8(block.id), axes);
    measured.unscaled = is_unscaled(block);
    if (!measured.unscaled) measured.mass = block.mass.mass;
    measured.axes_by_box = std::move(axes_by_box);
    if (observations[i])
      measured.deposit = observation_by_box(*observations[i], block.axes(), axes);
    // The scan's extents are within twice the deviation of the block's.
    measured.axis_error = reading.axis_error && !measured.unscaled
                              ? *reading.axis_error
                              : 2.0 * block.deviation.hausdorff;
    reported.population.blocks.push_back(std::move(measured));
    if (!reading.surfaces) continue;
    reported.surfaces.resize(reported.population.blocks.size());
    reported.surfaces.back() = surface_measures(block, axes, reading.roundness_edge);
  }
}

/// The first notes of a table, and how many rows they are about.
void add_brief_notes(std::vector<std::string>& brief, const std::string& input,
                     const DimensionTable& table) {
  for (std::size_t i = 0; i < std::min(kMaxBriefNotes, table.notes.size()); ++i) {
    brief.push_back(input + ": " + table.notes[i]);
  }
  if (table.notes.size() > kMaxBriefNotes) {
    brief.push_back(input + ": and " + std::to_string(table.notes.size() - kMaxBriefNotes) +
                    " more notes");
  }
  if (table.skipped_rows + table.reordered_rows + table.blocks_without_mass > 0) {
    brief.push_back(input + ": " + format_count(table.blocks.size(), "row") + " used, " +
                    std::to_string(table.skipped_rows) + " skipped, " +
                    std::to_string(table.reordered_rows) + " sorted, " +
                    std::to_string(table.blocks_without_mass) + " without a usable mass");
  }
}

/// Rows without a name of their own are named after `stem`, where there is one.
void add_table(ReportedPopulation& reported, const BlockMeasuringOptions& reading,
               const std::string& path, const DimensionColumns& columns, const std::string& stem) {
  DimensionTable table = read_dimension_table(path, columns);
  add_brief_notes(reported.brief_notes, path, table);
  for (MeasuredBlock& block : table.blocks) {
    if (!stem.empty() && block.name.starts_with("row ")) block.name = stem + " " + block.name;
    block.axis_error = reading.axis_error.value_or(kTapeError);
    reported.population.blocks.push_back(std::move(block));
  }
  for (const std::string& note : table.notes) {
    reported.notes.push_back(stem.empty() ? note : stem + ": " + note);
  }
  reported.skipped += table.skipped_rows;
}

void add_note(ReportedPopulation& reported, const std::string& note) {
  reported.notes.push_back(note);
  reported.brief_notes.push_back(reported.population.name + ": " + note);
}

/// Notes files that are the same, which counts their blocks as often.
void note_same_files(ReportedPopulation& reported) {
  std::map<std::string, std::vector<std::string>> names;  // by content
  for (const InputFile& input : reported.inputs) names[input.sha256].push_back(input.file);
  for (const InputFile& input : reported.inputs) {
    std::vector<std::string>& same = names[input.sha256];
    if (same.size() < 2) continue;
    const std::string times = std::to_string(same.size()) + " times";
    add_note(reported, "the same file is given " + times + " (" + comma_separated(same) +
                           "): its blocks are counted " + times);
    same.clear();  // noted once
  }
}

ReportedPopulation read_population(const PopulationFiles& files,
                                   const BlockMeasuringOptions& reading) {
  const DimensionColumns columns = parse_dimension_columns(files.columns, files.units);
  ReportedPopulation reported;
  std::string& name = reported.population.name;
  bool tables = false, libraries = false;
  for (const std::string& input : files.inputs) {
    const std::string stem = to_utf8(std::filesystem::path(input).stem().string());
    const bool library = is_block_library(input);
    (library ? libraries : tables) = true;
    if (library) {
      add_library(reported, reading, input);
    } else {
      add_table(reported, reading, input, columns, files.inputs.size() > 1 ? stem : std::string());
    }
    name += (name.empty() ? "" : " + ") + stem;
    reported.inputs.push_back({to_utf8(input), sha256_of_file(input)});
  }
  if (reported.population.blocks.empty()) {
    throw InputError(reported.inputs.front().file + ": it contains no block to classify");
  }
  if (reading.surfaces) reported.surfaces.resize(reported.population.blocks.size());
  const std::string box_words = "sides of the " + reading.box + " box of the rounded body";
  reported.measured = libraries && tables ? box_words + ", or as measured"
                      : libraries         ? box_words
                                          : "as measured";
  if (libraries) reported.reading.box = reading.box;
  if (tables) reported.reading.columns = files.columns;
  if (tables && !files.units.empty()) reported.reading.units = files.units;
  reported.reading.axis_error = reading.axis_error;
  note_same_files(reported);
  for (const std::string& note : population_notes(reported.population.blocks)) {
    add_note(reported, note);
  }
  return reported;
}

/// A file that is in both populations makes them alike.
void note_shared_files(const ReportedPopulation& first, ReportedPopulation& second) {
  for (const InputFile& a : first.inputs) {
    for (const InputFile& b : second.inputs) {
      if (a.sha256 != b.sha256) continue;
      add_note(second, "both populations hold the same file, " + a.file +
                           (a.file == b.file ? "" : " and " + b.file));
    }
  }
}

/// The second population with what it takes over from the first.
PopulationFiles files_against(const PopulationReportRequest& request) {
  PopulationFiles files = request.against;
  if (files.columns.empty()) files.columns = request.first.columns;
  if (files.units.empty()) files.units = request.first.units;
  return files;
}

}  // namespace

bool is_block_library(const std::string& path) {
  return is_hdf5(path) || path.ends_with(".h5") || path.ends_with(".hdf5");
}

DimensionColumns parse_dimension_columns(const std::string& text, const std::string& units) {
  DimensionColumns columns;
  if (!units.empty()) columns.units = parse_length_unit(units);
  std::map<std::string, std::string> quantities, given;  // by each other
  for (const std::string& item : split_comma_separated(text)) {
    const std::size_t equals = item.find('=');
    const std::string quantity = item.substr(0, equals);
    const std::string column = equals == std::string::npos ? "" : item.substr(equals + 1);
    const bool axis = quantity == "L" || quantity == "I" || quantity == "S";
    if (column.empty() || (!axis && quantity != "mass" && quantity != "name")) {
      throw InputError("`columns`: \"" + item +
                       "\" is not valid; expected for example L=5,I=6,S=7,mass=4 or "
                       "L=length,I=width,S=height,name=label");
    }
    if (!given.emplace(quantity, column).second) {
      throw InputError("`columns`: " + quantity + " is given as column " + given[quantity] +
                       " and as column " + column);
    }
    if (quantity != "name" && !quantities.emplace(column, quantity).second) {
      throw InputError("`columns`: column " + column + " is given as " + quantities[column] +
                       " and as " + quantity);
    }
    if (axis) {
      (quantity == "L" ? columns.L : quantity == "I" ? columns.I : columns.S) = column;
    } else {
      (quantity == "mass" ? columns.mass : columns.name) = column;
    }
  }
  return columns;
}

void PopulationReportRequest::check() const {
  options.check();
  if (first.inputs.empty()) throw InputError("no block library and no table of blocks is given");
  if (reading.axis_error && !kAxisErrorRange.contains(*reading.axis_error)) {
    throw InputError("`axis_error` = " + format_significant(*reading.axis_error, 6) + " must be " +
                     kAxisErrorRange.describe());
  }
  for (const PopulationFiles& files : {first, files_against(*this)}) {
    parse_dimension_columns(files.columns, files.units);
    for (const std::string& input : files.inputs) {
      if (!reading.box_given || is_block_library(input)) continue;
      throw InputError("`box`: " + input +
                       " is a table of measured axes, to which no box convention applies");
    }
  }
}

PopulationReport read_populations(const PopulationReportRequest& request) {
  request.check();
  PopulationReport report;
  report.options = request.options;
  std::vector<ReportedPopulation>& both = report.populations;
  both.push_back(read_population(request.first, request.reading));
  if (!request.against.inputs.empty()) {
    both.push_back(read_population(files_against(request), request.reading));
    note_shared_files(both[0], both[1]);
  }
  for (ReportedPopulation& reported : both) {
    reported.summary = summarise_population(reported.population, report.options);
    reported.deposit = summarise_scanned_deposit(reported.population, report.options);
  }
  if (both.size() < 2) return report;
  Population &a = both[0].population, &b = both[1].population;
  if (a.name == b.name) {  // the same file name in two folders
    a.name += " (1)";
    b.name += " (2)";
  }
  report.comparison = compare_populations(a, b, report.options);
  return report;
}

}  // namespace clast
