#pragma once
/// Tables of block axes measured by tape.
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Blocks of a table, with notes from reading it.
struct DimensionTable {
  std::vector<MeasuredBlock> blocks;
  std::vector<std::string>
      notes;  ///< notes on the unit, skipped rows, reordered axes and ignored masses
  std::size_t skipped_rows = 0;    ///< number of rows without three valid axes
  std::size_t reordered_rows = 0;  ///< number of rows whose axes were not in the order L >= I >= S
  std::size_t blocks_without_mass =
      0;  ///< number of blocks without a valid mass, if the table has a mass column
};

/// Columns of a table of block axes, each given by name or by number from 1.
struct DimensionColumns {
  std::string L = "L";
  std::string I = "I";
  std::string S = "S";
  std::optional<std::string> mass =
      {};  ///< if empty, a column called "mass" is used, if there is one
  std::optional<std::string> name =
      {};  ///< if empty, a column called "id", "name", "block" or similar is used
  std::optional<double> units =
      {};  ///< m per unit of L, I and S; if empty, that of the header, otherwise 1
};

/// Reads a table of block axes, separated by commas, semicolons, tabs or blanks.
///
/// Column names are compared without case and without a unit suffix ("L_m", "l (cm)", "mass [t]").
/// The suffix sets the unit unless `columns` does. If no column is called L, I or S, synonyms such
/// as "Length", "b-axis", "Dicke (cm)" or "Espesor" are accepted, with a note. Without a header
/// line, columns must be given by number. Fields may be quoted [rfc4180]. Decimal commas are
/// accepted unless the comma separates the columns.
///
/// Summary rows ("Mean", "SD", "Summe") are skipped with a note, as are rows with an axis that is
/// missing, unreadable, zero, negative or outside 1e-9 to 1e9 m. There are also notes on unnamed
/// rows equal to the mean or sum of the others, unreadable masses, text that is not UTF-8 (read as
/// Windows-1252), and a unit for which most blocks are longer than 50 m.
/// @throws InputError  if the file is missing or not text, a column is missing, ambiguous or used
///                     twice, units contradict each other, a row has another number of fields, or
///                     no row is valid
/// @cite rfc4180
DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns = {});

}  // namespace clast
