#pragma once
/// Headings of columns, as people and programs write them.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/length_unit.hpp"

namespace clast {

/// A heading taken apart: "Coord. X [ft]" has the name "coord. x", the word "x" and the unit ft.
struct ColumnHeading {
  std::string name;  ///< lower case, the unit cut off
  /// Words of letters and digits in lower case, without accents ("Höhe": "hohe"), and without those
  /// that say nothing, such as "coordinate" and "value", where others are left.
  std::vector<std::string> words;
  std::optional<NamedUnit> length;  ///< where the heading names it, in brackets or at its end
  std::string unit;                ///< the same, or another unit, as written; empty: none
  std::string bracketed;           ///< what stands in brackets at the end, in lower case

  /// The only word of the heading; empty where it has several or none.
  std::string single_word() const { return words.size() == 1 ? words.front() : std::string(); }
  /// "start_x"
  std::string snake_case() const;
};

/// @param field  without its quotes, as `DelimitedTextReader` gives it
ColumnHeading parse_heading(std::string_view field);

enum class SummaryLabel {
  kNone,
  kAmbiguous,  ///< of one or two letters, which may name an item too: "SD", "n"
  kCertain
};

/// Whether a text names a row that sums up the others, in English, German, French, Italian or
/// Spanish: "Mean", "SD", "Mittelwert", "Écart-type", "Totale", "Máx.".
SummaryLabel detect_summary_label(std::string_view text);

/// Whether a row may be a heading: none of its fields is a number, and, where blanks separate, none
/// ends as a sentence or its parts do.
bool is_possible_heading(const std::vector<std::string_view>& fields, char separator);

}  // namespace clast
