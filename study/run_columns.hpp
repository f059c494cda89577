#pragma once
/// The columns of the table of runs, declared once: for runs.csv, for groups of runs, and for their
/// part of docs/formats.md, which a test compares.
#include <cstdint>
#include <span>
#include <string>
#include <variant>

#include "study/comparison.hpp"

namespace clast {

/// A count, a number (not finite where nothing is known), or a text.
using RunCell = std::variant<std::uint64_t, double, std::string>;

struct RunColumn {
  enum class Use { kTable, kGroups, kBoth };

  const char* name;  ///< with its unit
  const char* unit;
  const char* meaning;  ///< Markdown
  Use use;
  RunCell (*value)(const CampaignResults& results, const RunRow& row);

  bool in_table() const { return use != Use::kGroups; }
  bool groups() const { return use != Use::kTable; }  ///< runs can be grouped by it
};

/// In the order of runs.csv.
std::span<const RunColumn> run_columns();

/// Adds a group for every value of a column, over all files, in rising order; numbers with more
/// than `kMostValues` values are divided at their quartiles: "mass_kg 120 to 250".
/// @throws InputError  no such column; the message lists them
void append_column_groups(Comparison& comparison, const std::string& column);

inline constexpr std::size_t kMostValues = 8;

}  // namespace clast
