#pragma once
/// Reading, summary and comparison of block populations from libraries and tables.
#include <optional>
#include <string>
#include <vector>

#include "classify/dimension_table.hpp"
#include "report/reported_population.hpp"

namespace clast {

/// Input files of a population, and options for reading them.
struct PopulationFiles {
  std::vector<std::string> inputs;  ///< libraries or text tables
  std::string columns;              ///< columns of text tables, such as "L=5,I=6,S=7,mass=4"
  std::string units;                ///< unit of lengths; if empty, that of the table heading, or m
};

struct BlockMeasuringOptions {
  std::string box = "smallest";  ///< box whose sides are the axes of library blocks
  /// True if the user requested the box, which is an error for text tables.
  bool box_given = false;
  /// Error of the axes, m; if empty, it depends on the kind of source.
  std::optional<double> axis_error = {};
  /// True if surface measures of library blocks are computed.
  bool surfaces = false;
  std::optional<double> roundness_edge = {};
};

/// Input files and options of a report on one population, or on two that are compared.
struct PopulationReportRequest {
  PopulationFiles first = {{}, "L=L,I=I,S=S", ""};
  /// Second population; not used without inputs.
  PopulationFiles against = {};
  BlockMeasuringOptions reading = {};
  PopulationOptions options = {};

  /// Checks columns, units and schemes.
  /// @throws InputError  if columns, units or schemes are invalid, or a box is requested for a
  ///                     table
  void check() const;
};

/// True if a file is a block library rather than a text table.
bool is_block_library(const std::string& path);

/// Parses columns such as "L=5,I=6,S=7,mass=4,name=2", and the unit of lengths, which may be empty.
/// @throws InputError  if columns or unit are invalid
DimensionColumns parse_dimension_columns(const std::string& columns, const std::string& units);

/// Reads, summarises and compares the requested populations.
/// @throws InputError  if `PopulationReportRequest::check` throws, or if a file cannot be read or
/// has no
///                     block
PopulationReport read_populations(const PopulationReportRequest& request);

}  // namespace clast
