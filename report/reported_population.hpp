#pragma once
/// What is known of one population of blocks, or of two side by side.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "classify/equilibria.hpp"
#include "classify/population_summary.hpp"
#include "classify/roundness.hpp"

namespace clast {

/// A file that was read.
struct InputFile {
  std::string file;  ///< as it was named
  std::string sha256;
};

/// How the axes of a population were asked for; what was not given or does not apply is none.
struct MeasuringOptions {
  std::optional<std::string> box = {};      ///< convention, for blocks of libraries
  std::optional<std::string> columns = {};  ///< of tables
  std::optional<std::string> units = {};    ///< of tables
  std::optional<double> axis_error = {};    ///< m
};

/// What only a whole surface shows.
struct SurfaceMeasures {
  std::map<std::string, double> indices;  ///< of the axes too
  std::optional<Equilibria> sides;        ///< none of a ball or a capsule
  std::optional<Roundness> roundness;     ///< where it was asked for
};

/// A population with where it came from.
struct ReportedPopulation {
  Population population;
  PopulationSummary summary;
  std::string measured;  ///< how L, I, S were taken: "sides of the smallest box", "as in the table"
  MeasuringOptions reading;
  std::vector<InputFile> inputs;
  std::size_t skipped = 0;         ///< rows of tables
  std::vector<std::string> notes;  ///< what was wrong with the input
  /// The notes as a terminal has room for them: of each table the first, with its name.
  std::vector<std::string> brief_notes;
  /// Of every block, none for rows of tables; empty where they were not asked for.
  std::vector<std::optional<SurfaceMeasures>> surfaces;
};

/// One population or two; two are compared.
struct PopulationReport {
  std::vector<ReportedPopulation> populations;
  std::optional<PopulationComparison> comparison;
  PopulationOptions options;
};

}  // namespace clast
