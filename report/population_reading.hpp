#pragma once
/// Reading, summary and comparison of block populations from libraries and tables.
#include <optional>
#include <string>
#include <vector>

#include "classify/dimension_table.hpp"
#include "report/reported_population.hpp"

namespace clast {

/// Input files of a population, and how tables are read.
struct PopulationFiles {
  std::vector<std::string> inputs;  ///< libraries or text tables
  std::string columns;              ///< "L=5,I=6,S=7,mass=4"
  std::string units;                ///< of length; empty: from the table header, or m
};

struct BlockMeasuringOptions {
  std::string box = "smallest";           ///< box whose sides are the axes of library blocks
  bool box_given = false;                 ///< explicitly requested, which is an error for tables
  std::optional<double> axis_error = {};  ///< of the axes, m; empty: by the kind of source
  /// Compute surface measures of library blocks; if `roundness_edge` is given, also roundness with
  /// triangles of that edge length (m).
  bool surfaces = false;
  std::optional<double> roundness_edge = {};
};

/// Request for one population, or two to compare.
struct PopulationRequest {
  PopulationFiles first = {{}, "L=L,I=I,S=S", ""};
  /// Second population; none without inputs. Empty columns and units are those of the first.
  PopulationFiles against = {};
  BlockMeasuringOptions reading = {};
  PopulationOptions options = {};

  /// Checks all fields.
  /// @throws InputError  if columns, units or schemes are invalid, or a box is requested for a
  ///                     table
  void check() const;
};

/// True if a file is a block library, by its content or else its name.
bool is_library(const std::string& path);

/// Parses "L=5,I=6,S=7,mass=4,name=2" and the unit of the lengths (may be empty).
/// @throws InputError  naming `columns` or `units`
DimensionColumns parse_dimension_columns(const std::string& columns, const std::string& units);

/// Reads, summarises and compares the requested populations.
/// @throws InputError  as `PopulationRequest::check`; or if a file cannot be read or has no block
PopulationReport read_populations(const PopulationRequest& request);

}  // namespace clast
