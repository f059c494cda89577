#pragma once
/// Diagrams of one or two block populations, for the page and as files.
#include <cstddef>
#include <map>
#include <string>

#include "report/reported_population.hpp"

namespace clast::report_detail {

/// Diagrams of block populations: SVG texts by name.
using PopulationDiagrams = std::map<std::string, std::string>;
/// Draws all diagrams of one or two populations: shape diagrams, size distributions and class
/// fractions.
PopulationDiagrams draw_population_diagrams(const PopulationReport& report);

/// Returns the suffix of the names of the diagrams of a population; empty for a single population.
/// @param number  index of the population
std::string population_file_suffix(const PopulationReport& report, std::size_t number);
/// Returns the name of the diagram of class fractions of a scheme.
/// @param scheme  index of the scheme in the summaries
std::string class_fractions_diagram_name(const PopulationReport& report, std::size_t scheme);

/// True if at least one block of a population has a scale.
bool has_scaled_blocks(const ReportedPopulation& reported);

/// Formats a mass with four significant digits, without exponent.
std::string format_block_mass(double mass);

}  // namespace clast::report_detail
