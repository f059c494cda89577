#pragma once
/// Tables that hold the same few numbers in every row, such as points and rotations.
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/number_range.hpp"

namespace clast {

struct NumberRow {
  std::size_t line = 0;  ///< of the file, from 1
  std::vector<double> values;
};

/// What a table of numbers must hold.
struct NumberTable {
  /// Of the columns in the order wanted; each has one name or several, in lower case.
  std::vector<std::vector<std::string>> names;
  NumberRange range;    ///< of every number
  std::string meaning;  ///< completes "a line must be ...": "three numbers, x y z"
};

/// The name of a column of lengths, in lower case: "X_m" is the column x.
std::string column_without_unit(std::string_view field);

/// Reads a table by `DelimitedText`; what follows a # is skipped. The first row may be a
/// heading: where it names all columns ("X", "y_m"), these columns are read and others are not,
/// else a row has as many numbers as there are columns.
/// @throws InputError  no file, no text or no row; a row of another number of fields, or a field
///                     that is no number or out of range: file, line and what was found
std::vector<NumberRow> read_number_table(const std::filesystem::path& file,
                                         const NumberTable& table);

}  // namespace clast
