#pragma once
/// Numeric tables with equal rows, such as points and rotations.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/number_range.hpp"

namespace clast {

struct NumericRow {
  std::size_t line = 0;  ///< in the file, from 1
  std::vector<double> values;
};

struct NumericTableSpec {
  /// Names of the columns in the required order; each has one or several lower-case names.
  std::vector<std::vector<std::string>> names;
  NumberRange range;
  std::string meaning;  ///< completes "a line must be ...": "three numbers, x y z"
  /// Finds the columns in a heading; returns empty if some are missing. By default, uses `names`.
  /// @throws InputError  without the file name
  std::function<std::optional<std::vector<std::size_t>>(const std::vector<std::string_view>&)>
      find = {};
};

/// Returns the lower-case name of a length column without unit: "X_m" gives "x".
std::string strip_unit(std::string_view field);

/// Reads a table with `DelimitedTextReader`; text after # is ignored. If the first row names all
/// columns ("X", "y_m"), these columns are read and others ignored. Without such a heading, each
/// row must have as many numbers as there are columns; a title is skipped.
/// @throws InputError  if the file, its text or all rows are missing; the heading lacks columns; a
///                     row has another number of fields, a field that is not a number or out of
///                     range, or is a summary row; names file, line and text
std::vector<NumericRow> read_numeric_table(const std::filesystem::path& file,
                                           const NumericTableSpec& table);

}  // namespace clast
