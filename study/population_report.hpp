#pragma once
/// What is known of one population of blocks, or of two side by side, as tables, diagrams and a
/// page.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "classify/population_summary.hpp"
#include "core/output_folder.hpp"

namespace clast {

/// A file that was read.
struct InputFile {
  std::string file;  ///< as it was named
  std::string sha256;
};

/// How the axes of a population were asked for; what was not given or does not apply is none.
struct ReadingOptions {
  std::optional<std::string> box = {};      ///< convention, for blocks of libraries
  std::optional<std::string> columns = {};  ///< of tables
  std::optional<std::string> units = {};    ///< of tables
  std::optional<double> axis_error = {};    ///< m
};

/// A population with where it came from.
struct ReportedPopulation {
  Population population;
  PopulationSummary summary;
  std::string measured;  ///< how L, I, S were taken: "sides of the smallest box", "as in the table"
  ReadingOptions reading;
  std::vector<InputFile> inputs;
  std::vector<std::string> notes;  ///< what was wrong with the input
};

/// One population or two; two are compared.
struct PopulationReport {
  std::vector<ReportedPopulation> populations;
  std::optional<PopulationComparison> comparison;
  PopulationOptions options;
};

/// Column that holds the class of a scheme: "shape" for garcia, as everywhere; else the scheme's
/// name with _ for -.
std::string class_column(const std::string& scheme);

/// shares.csv, sizes.csv and tests.csv as text; columns in docs/formats.md.
std::string shares_csv(const PopulationReport& report);
std::string sizes_csv(const PopulationReport& report);
std::string tests_csv(const PopulationReport& report);

/// classes.csv: a row per block with all classes and indices. Rows are made in parallel and written
/// in order, so the file is the same for any number of threads and never whole in memory.
/// @throws InputError  can't be written
void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads = 0);

/// Pictures as SVG by the names of their files.
using Diagrams = std::map<std::string, std::string>;
/// "sneed_folk", "zingg", "size" (with "_1" and "_2" for two populations), "s_c", and "shares_"
/// with the class column of each scheme; "sizes" for two populations over each other.
Diagrams population_diagrams(const PopulationReport& report);

/// How `folder` is known to be one that `write_population_report` filled, by the diagrams that its
/// provenance.json lists.
FolderKind population_folder(const std::filesystem::path& folder);

/// Writes classes.csv, shares.csv, sizes.csv, tests.csv, provenance.json, the diagrams as .svg and
/// report.html, one page that needs no network, to `folder`.
/// @throws InputError  the folder can't be made or written to
void write_population_report(const PopulationReport& report, const std::filesystem::path& folder);

}  // namespace clast
