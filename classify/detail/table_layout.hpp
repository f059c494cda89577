#pragma once
/// Layout of a table of axes: columns and units.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "classify/dimension_table.hpp"
#include "core/files/delimited_text.hpp"

namespace clast::classify_detail {

inline constexpr std::array<const char*, 3> kAxisNames = {"L", "I", "S"};

struct DimensionTableLayout {
  std::string file;  ///< file name for messages
  char separator = ',';
  bool has_header = false;
  bool has_summary = false;  ///< true if there are summary rows, such as the mean of the others
  std::array<std::size_t, 3> axes{};  ///< column indices of L, I and S
  std::optional<std::size_t> mass;
  std::optional<std::size_t> name;
  double units = 1.0;            ///< m per unit of the table
  bool units_are_known = false;  ///< true if the user or the header states the unit
  double mass_units = 1.0;       ///< kg per unit of the table
};

/// Finds the columns by name or number in the first row, which may be the header.
/// @param notes  receives notes on the units
/// @throws InputError  if columns or units are invalid (see `read_dimension_table`)
DimensionTableLayout find_dimension_table_layout(const Record& first, char separator,
                                                 const DimensionColumns& columns,
                                                 const std::string& file,
                                                 std::vector<std::string>& notes);

}  // namespace clast::classify_detail
