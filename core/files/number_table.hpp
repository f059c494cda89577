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
  std::size_t line = 0;  ///< line in the file, from 1
  std::vector<double> values;
};

struct NumericTableSpec {
  /// Accepted lower-case names of each column, in the required order of the columns.
  std::vector<std::vector<std::string>> column_names;
  NumberRange range;
  std::string expected_line;  ///< required content of a line, for messages: "three numbers, x y z"
  /// Optional function that finds the column indices in a heading; empty if columns are missing. If
  /// it is not set, `column_names` are searched.
  /// @throws InputError  if the heading is invalid; the message does not name the file
  std::function<std::optional<std::vector<std::size_t>>(const std::vector<std::string_view>&)>
      find_columns = {};
};

/// Returns the lower-case name of a length column without its unit: "X_m" gives "x".
std::string strip_unit(std::string_view field);

/// Reads a table of numbers. Text after # is ignored. If the first row names all required columns
/// ("X", "y_m"), these columns are read and others ignored. Without such a heading, each row must
/// have as many numbers as there are columns; a title is skipped.
/// @throws InputError  if the file is missing or has no rows, if the heading lacks columns, if a
///                     field is not a number or out of range, if the number of fields differs, or
///                     if a row is a summary row; the message names file, line and text
std::vector<NumericRow> read_numeric_table(const std::filesystem::path& file,
                                           const NumericTableSpec& table);

}  // namespace clast
