#pragma once
/// Populations of blocks out of libraries and tables, as `clast classify` takes them.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/reported_population.hpp"

namespace clast {

/// Which files a population is made of, and how to read the tables among them.
struct PopulationFiles {
  std::vector<std::string> inputs;  ///< libraries or text tables
  std::string columns;              ///< "L=5,I=6,S=7,mass=4"
  std::string units;                ///< of length; empty: as the header of a table says, else m
};

/// What is taken of a block.
struct BlockReading {
  std::string box = "smallest";      ///< whose sides are the axes of a library's blocks
  bool box_given = false;            ///< asked for, which no table can answer
  std::optional<double> axis_error;  ///< of the axes, m; none: as the source lets expect
  /// Measures on the surfaces of a library's blocks, roundness with triangles of this edge (m) too.
  bool surfaces = false;
  std::optional<double> roundness_edge;
};

/// A population as it was read, with what only the printed form of it needs.
struct ReadPopulation {
  ReportedPopulation reported;
  std::vector<nlohmann::ordered_json> surfaces;  ///< of every block; null for rows of tables
  std::string box;                               ///< convention of the axes
  std::size_t skipped = 0;                       ///< rows of tables
  std::string said;                              ///< notes for the terminal
};

/// Whether a file is read as a block library: by its content, else by its name.
bool is_library(const std::string& path);

/// One population out of several files.
/// @throws CLI::ValidationError  columns that can't be understood; a box asked for of a table
/// @throws InputError            files that can't be read
ReadPopulation read_population(const PopulationFiles& files, const BlockReading& reading);

}  // namespace clast
