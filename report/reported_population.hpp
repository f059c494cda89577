#pragma once
/// Results for one block population, or two.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "classify/equilibria.hpp"
#include "classify/population_summary.hpp"
#include "classify/roundness.hpp"

namespace clast {

struct InputFile {
  std::string file;  ///< path as given
  std::string sha256;
};

/// Options by which axes were measured; empty if not given or not applicable.
struct MeasuringOptions {
  std::optional<std::string> box = {};      ///< convention, for library blocks
  std::optional<std::string> columns = {};  ///< of tables
  std::optional<std::string> units = {};    ///< of tables
  std::optional<double> axis_error = {};    ///< m
};

/// Measures that need the whole surface of a block.
struct SurfaceMeasures {
  std::map<std::string, double> indices;  ///< including indices of the axes
  std::optional<Equilibria> sides;        ///< empty for balls and capsules
  std::optional<Roundness> roundness;     ///< if requested
};

struct ReportedPopulation {
  Population population;
  PopulationSummary summary;
  std::string
      measured;  ///< how L, I, S were measured: "sides of the smallest box", "as in the table"
  MeasuringOptions reading;
  std::vector<InputFile> inputs;
  std::size_t skipped = 0;         ///< number of skipped table rows
  std::vector<std::string> notes;  ///< problems of the inputs
  /// Short notes for terminals: the first one of each table, with its name.
  std::vector<std::string> brief_notes;
  /// Surface measures, one entry per block; `nullopt` for blocks read from a table. Empty if not
  /// requested.
  std::vector<std::optional<SurfaceMeasures>> surfaces;
};

/// One population, or two with their comparison.
struct PopulationReport {
  std::vector<ReportedPopulation> populations;
  std::optional<PopulationComparison> comparison;
  PopulationOptions options;
};

}  // namespace clast
