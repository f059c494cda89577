#pragma once
/// Tape-measured blocks from text tables.
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// A table and what was wrong with it.
struct DimensionTable {
  std::vector<MeasuredBlock> blocks;
  std::vector<std::string>
      notes;                  ///< the unit, skipped rows, sorted axes, masses left out, by line
  std::size_t skipped = 0;    ///< rows without three usable axes
  std::size_t sorted = 0;     ///< rows whose axes were not in the order L >= I >= S
  std::size_t without_mass = 0;  ///< blocks without a usable mass where there is a column for it
};

/// Which columns hold what: names or 1-based numbers.
struct DimensionColumns {
  std::string L = "L";
  std::string I = "I";
  std::string S = "S";
  std::optional<std::string> mass = {};  ///< none: a column called "mass", if there is one
  std::optional<std::string> name =
      {};                            ///< none: a column called "id", "name", "block" or the like
  std::optional<double> units = {};  ///< m per unit of L, I, S; none: as the header says, else 1
};

/// Reads comma, semicolon, tab or blank separated tables, with a header line or without one (then
/// the columns must be numbers). Column names are matched without case and with a unit ending
/// ("L_m", "l (cm)", "mass [t]") cut off; without another unit asked for it is the unit of the
/// column. Where no column is called L, I or S, words for them count ("Length", "b-axis", "Dicke
/// (cm)", "Espesor"), with a note. Rows that are named as summaries of the others ("Mean", "SD",
/// "Summe") are skipped and noted; nameless ones that are their mean or sum are noted. Fields may
/// be quoted, also over several lines [rfc4180]; decimal commas are read where the comma is not the
/// separator. A row with more or fewer fields than the first is refused, and so is a number with a
/// comma in a table that separates by commas; rows with zero, negative, missing or unreadable axes,
/// or with axes outside 1e-9 to 1e9 m, are skipped and noted; a mass that can't be read is noted
/// and left out. Text that is not UTF-8 is read as Windows-1252; that, and a unit that makes most
/// blocks longer than 50 m, is noted too. Names and notes are UTF-8.
/// @throws InputError  no file, not text, no such column (the message lists those found), several
///                     columns of that name, one column for two quantities, columns with different
///                     units, a row of another number of fields (its line), or no usable row
/// @cite rfc4180
DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns = {});

}  // namespace clast
