#pragma once
/// Tables of block axes measured by tape.
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Blocks of a table, and the notes made while reading.
struct DimensionTable {
  std::vector<MeasuredBlock> blocks;
  std::vector<std::string>
      notes;                ///< the unit, skipped rows, sorted axes, masses left out, by line
  std::size_t skipped = 0;  ///< rows without three valid axes
  std::size_t sorted = 0;   ///< rows whose axes were not in the order L >= I >= S
  std::size_t without_mass =
      0;  ///< blocks without a valid mass although the table has a mass column
};

/// Columns of the quantities, each by name or 1-based number.
struct DimensionColumns {
  std::string L = "L";
  std::string I = "I";
  std::string S = "S";
  std::optional<std::string> mass = {};  ///< none: a column called "mass", if there is one
  std::optional<std::string> name =
      {};                            ///< none: a column called "id", "name", "block" or the like
  std::optional<double> units = {};  ///< m per unit of L, I, S; none: as the header says, else 1
};

/// Reads a table separated by commas, semicolons, tabs or blanks.
///
/// Column names are matched without case and without a unit suffix ("L_m", "l (cm)", "mass [t]"),
/// which sets the unit unless `columns` does. If no column is called L, I or S, synonyms such as
/// "Length", "b-axis", "Dicke (cm)" or "Espesor" are accepted, with a note. Without a header line
/// the columns must be given by number. Fields may be quoted [rfc4180]; decimal commas are accepted
/// unless the comma separates the columns.
///
/// Skipped with a note: summary rows ("Mean", "SD", "Summe") and rows with an axis that is missing,
/// unreadable, zero, negative or outside 1e-9 to 1e9 m. Noted: unnamed rows equal to the mean or
/// sum of the others, unreadable masses, text that is not UTF-8 (read as Windows-1252), and a unit
/// by which most blocks are longer than 50 m. Names and notes are UTF-8.
/// @throws InputError  if the file is missing or not text, a column is missing, ambiguous or used
///                     twice, units contradict each other, a row has another number of fields (or a
///                     decimal comma in a comma-separated table), or no row is valid
/// @cite rfc4180
DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns = {});

}  // namespace clast
