#pragma once
/// The diagrams of a population of blocks, or of two: shown by its page, and files of their own.
#include <cstddef>
#include <map>
#include <string>

#include "report/reported_population.hpp"

namespace clast::report_detail {

/// Pictures as SVG by the names of their files.
using Diagrams = std::map<std::string, std::string>;
/// "sneed_folk", "zingg", "size" (with "_1" and "_2" for two populations), "s_c", and "shares_"
/// with the class column of each scheme; "sizes" for two populations over each other.
Diagrams draw_population_diagrams(const PopulationReport& report);

/// What sets the diagrams of one population apart from those of the other, in their names: nothing
/// where there is one only.
/// @param number  of the population, from 0
std::string population_file_suffix(const PopulationReport& report, std::size_t number);
/// The diagram of the shares of a scheme's classes.
/// @param scheme  its number in the summaries
std::string fractions_file_name(const PopulationReport& report, std::size_t scheme);

/// Not where every block is unscaled.
bool has_sizes(const ReportedPopulation& reported);

/// Whole kilograms where four digits would be an exponent.
std::string format_block_mass(double mass);

}  // namespace clast::report_detail
