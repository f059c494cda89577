#pragma once
/// Sizes of the blocks of a population: curves, fitted laws, and how shape goes with size.
#include <string>

#include "study/population_report.hpp"

namespace clast {

/// Characters of a population's name over a column.
inline constexpr std::size_t kMostHead = 14;

/// What sets the diagrams of one population apart from those of the other, in their names: nothing
/// where there is one only.
std::string population_suffix(const PopulationReport& report, std::size_t number);

/// Not where every block is unscaled.
bool has_sizes(const ReportedPopulation& reported);

/// The curves of all populations over each other, by number.
std::string sizes_chart(const PopulationReport& report);
/// The curves of one, by number and by mass, and the laws fitted to the first.
/// @param number  of the population, from 0
std::string size_chart(const ReportedPopulation& reported, std::size_t number);

/// The section of the page.
/// @param diagrams  with "sizes" where there are several populations, and "size" + suffix of each
std::string size_section(const PopulationReport& report, const Diagrams& diagrams);

}  // namespace clast
