#pragma once
/// Tables that hold the same few numbers in every row, such as points and rotations.
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
  std::size_t line = 0;  ///< of the file, from 1
  std::vector<double> values;
};

/// What a table of numbers must hold.
struct NumericTableSpec {
  /// Of the columns in the order wanted; each has one name or several, in lower case.
  std::vector<std::vector<std::string>> names;
  NumberRange range;    ///< of every number
  std::string meaning;  ///< completes "a line must be ...": "three numbers, x y z"
  /// Finds the columns in the fields of a heading; none where it does not name them all. Absent: by
  /// `names`.
  /// @throws InputError  without file name
  std::function<std::optional<std::vector<std::size_t>>(const std::vector<std::string_view>&)>
      find = {};
};

/// The name of a column of lengths, in lower case: "X_m" is the column x.
std::string strip_unit(std::string_view field);

/// Reads a table by `DelimitedTextReader`; what follows a # is skipped. The first row may be a
/// heading: where it names all columns ("X", "y_m"), these columns are read and others are not.
/// Below a title, or without one, a row has as many numbers as there are columns.
/// @throws InputError  no file, no text or no row; a heading that does not name all columns; a row
///                     of another number of fields, a field that is no number or out of range, or
///                     a row that sums up the others: file, line and what was found
std::vector<NumericRow> read_numeric_table(const std::filesystem::path& file,
                                         const NumericTableSpec& table);

}  // namespace clast
