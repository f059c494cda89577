#pragma once
/// Which columns of a table of tape measures hold what, and in which unit.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "classify/dimension_table.hpp"
#include "core/files/delimited_text.hpp"

namespace clast::classify_detail {

inline constexpr std::array<const char*, 3> kAxisNames = {"L", "I", "S"};

struct TableLayout {
  std::string file;  ///< for messages
  char separator = ',';
  bool has_header = false;
  bool has_summary = false;           ///< a row is named the mean or another summary of the others
  std::array<std::size_t, 3> axes{};  ///< columns of L, I, S
  std::optional<std::size_t> mass;
  std::optional<std::size_t> name;
  double units = 1.0;            ///< m
  bool units_are_known = false;  ///< asked for, or named by the header
  double mass_units = 1.0;       ///< kg
};

/// Finds the columns by name or number in the first row of a table, which may be its header.
/// @param notes  receives what a reader should know of the units
/// @throws InputError  as `read_dimension_table` says of columns and units
TableLayout find_table_layout(const Record& first, char separator, const DimensionColumns& columns,
                         const std::string& file, std::vector<std::string>& notes);

}  // namespace clast::classify_detail
