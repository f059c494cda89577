#pragma once
/// What runs can be grouped by.
#include <string>
#include <vector>

#include "study/comparison.hpp"

namespace clast {

/// Names of the columns, as in runs.csv.
std::vector<std::string> run_columns();

/// Adds a group for every value of a column, over all files, in rising order; numbers with more
/// than `kMostValues` values are divided at their quartiles: "mass_kg 120 to 250".
/// @throws InputError  no such column; the message lists them
void append_column_groups(Comparison& comparison, const std::string& column);

inline constexpr std::size_t kMostValues = 8;

}  // namespace clast
