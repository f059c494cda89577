#pragma once
/// Tape-measured blocks from text tables.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classify/form.hpp"

namespace clast {

/// One usable row.
struct MeasuredBlock {
  std::string name;  ///< from a column "id", "name" or "block", else "row <line>"
  Axes axes;
  std::optional<double> mass = std::nullopt;  ///< kg, where a column of masses was asked for
};

/// A table and what was wrong with it.
struct DimensionTable {
  std::vector<MeasuredBlock> blocks;
  std::size_t skipped = 0;         ///< rows that could not be used, each with a note
  std::vector<std::string> notes;  ///< skipped rows and re-sorted axes, each with its line
};

/// Which columns hold the axes: names or 1-based numbers.
struct DimensionColumns {
  std::string L = "L";
  std::string I = "I";
  std::string S = "S";
  std::string mass = "";  ///< in kg; empty: the table holds none
  double unit = 1.0;      ///< metres per unit of the table
};

/// Reads comma, semicolon, tab or blank separated tables, with a header line or without one (then
/// the columns must be numbers). Column names are matched without case and with a unit ending
/// ("L_m", "l (cm)") cut off. Rows with zero, negative, missing or unreadable axes or
/// masses are skipped and noted.
/// @throws InputError  no file, no such column (the message lists those found), or no usable row
DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns = {});

}  // namespace clast
