#pragma once
/// Populations of blocks out of libraries and tables, summarised and compared.
#include <optional>
#include <string>
#include <vector>

#include "classify/dimension_table.hpp"
#include "report/reported_population.hpp"

namespace clast {

/// Which files a population is made of, and how to read the tables among them.
struct PopulationFiles {
  std::vector<std::string> inputs;  ///< libraries or text tables
  std::string columns;              ///< "L=5,I=6,S=7,mass=4"
  std::string units;                ///< of length; empty: as the header of a table says, else m
};

/// What is taken of a block.
struct BlockMeasuringOptions {
  std::string box = "smallest";           ///< whose sides are the axes of a library's blocks
  bool box_given = false;                 ///< asked for, which no table can answer
  std::optional<double> axis_error = {};  ///< of the axes, m; none: as the source lets expect
  /// Measures on the surfaces of a library's blocks, roundness with triangles of this edge (m) too.
  bool surfaces = false;
  std::optional<double> roundness_edge = {};
};

/// One population, or two to compare.
struct PopulationRequest {
  PopulationFiles first = {{}, "L=L,I=I,S=S", ""};
  /// None without inputs. Columns and units that are empty are those of the first.
  PopulationFiles against = {};
  BlockMeasuringOptions reading = {};
  PopulationOptions options = {};

  /// @throws InputError  naming the field: columns, units or schemes that can't be understood, a
  ///                     box for a table
  void check() const;
};

/// Whether a file is read as a block library: by its content, else by its name.
bool is_library(const std::string& path);

/// "L=5,I=6,S=7,mass=4,name=2" and the unit of the lengths, empty for none.
/// @throws InputError  naming `columns` or `units`
DimensionColumns columns_from(const std::string& columns, const std::string& units);

/// Reads, summarises and compares what is asked for.
/// @throws InputError  as `PopulationRequest::check`; files that can't be read or hold no block
PopulationReport read_populations(const PopulationRequest& request);

}  // namespace clast
