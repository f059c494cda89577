#pragma once
/// Results of reports on block populations.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "classify/equilibria.hpp"
#include "classify/population_summary.hpp"
#include "classify/roundness.hpp"
#include "classify/scanned_deposit.hpp"

namespace clast {

struct InputFile {
  std::string file;  ///< path as given
  std::string sha256;
};

/// Options that were used to measure the axes of blocks; empty if not given.
struct AppliedMeasuringOptions {
  std::optional<std::string> box = {};      ///< box whose sides are the axes, for library blocks
  std::optional<std::string> columns = {};  ///< columns of tables
  std::optional<std::string> units = {};    ///< unit of lengths in tables
  std::optional<double> axis_error = {};    ///< error of the axes, m
};

/// Measures computed from the whole surface of a block.
struct SurfaceMeasures {
  /// Shape indices by name, including those computed from the axes.
  std::map<std::string, double> indices;
  std::optional<StaticEquilibriumCounts>
      sides;                           ///< number of equilibria; empty for balls and capsules
  std::optional<Roundness> roundness;  ///< roundness; empty if not requested
};

struct ReportedPopulation {
  Population population;
  PopulationSummary summary;
  /// Statistics of the blocks of scanned deposits; empty if there are fewer than three.
  std::optional<ScannedDepositSummary> deposit;
  /// Origin of L, I, S, such as "sides of the smallest box" or "as in the table".
  std::string measured;
  AppliedMeasuringOptions reading;
  std::vector<InputFile> inputs;
  std::size_t skipped = 0;         ///< number of skipped table rows
  std::vector<std::string> notes;  ///< notes on problems of the inputs
  /// Short notes for terminals, one per text table.
  std::vector<std::string> brief_notes;
  /// Surface measures, one entry per block; `nullopt` for blocks read from a table. Empty if not
  /// requested.
  std::vector<std::optional<SurfaceMeasures>> surfaces;
};

/// Results for one population, or for two with their comparison.
struct PopulationReport {
  std::vector<ReportedPopulation> populations;
  std::optional<PopulationComparison> comparison;
  PopulationOptions options;
};

}  // namespace clast
