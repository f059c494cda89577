#pragma once
/// What is known of one population of blocks, or of two side by side.
#include <optional>
#include <string>
#include <vector>

#include "classify/population_summary.hpp"

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

}  // namespace clast
