#pragma once
/// The tables of `clast compare` and `clast classify` by name, as columns of values; columns in
/// docs/formats.md.
#include <string>
#include <vector>

#include "core/files/table_values.hpp"
#include "report/reported_population.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// "runs", "barriers", "crossings", ...: the files that `write_comparison` writes, without ".csv".
const std::vector<std::string>& comparison_table_names();
/// @throws InputError  no such table; the message lists them
TableValues comparison_table(const Comparison& comparison, const std::string& name);

/// "classes", "shares", "sizes", "tests": the files of `write_population_report`.
const std::vector<std::string>& population_table_names();
/// @throws InputError  no such table; the message lists them
TableValues population_table(const PopulationReport& report, const std::string& name);

}  // namespace clast
