#pragma once
/// Parsing of column headings.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/length_unit.hpp"

namespace clast {

/// Parsed heading of a table column. "Coord. X [ft]" has the name "coord. x", the word "x" and the
/// unit ft.
struct ColumnHeading {
  std::string name;  ///< lower case, without unit
  /// Alphanumeric words in lower case without accents ("Höhe" gives "hohe"). Generic words such as
  /// "coordinate" and "value" are left out if other words remain.
  std::vector<std::string> words;
  std::optional<NamedUnit> length_unit;  ///< length unit in brackets or at the end
  std::string unit;                      ///< any unit as written; empty if there is none
  std::string bracketed_text;            ///< text in brackets at the end, lower case

  /// Returns the only word of the heading; empty if it has none or several.
  std::string single_word() const { return words.size() == 1 ? words.front() : std::string(); }
  /// Returns the words joined by underscores: "start_x".
  std::string snake_case() const;
};

/// Parses the heading of a table column.
/// @param field  heading without quotes, as returned by `DelimitedTextReader`
ColumnHeading parse_heading(std::string_view field);

/// Certainty that a text labels a summary row of a table, such as the mean of the other rows.
enum class SummaryRowLabel {
  kNone,
  kAmbiguous,  ///< one or two letters that may also name an item: "SD", "n"
  kCertain
};

/// Detects labels of summary rows in English, German, French, Italian or Spanish: "Mean", "SD",
/// "Mittelwert", "Écart-type", "Totale", "Máx.".
SummaryRowLabel detect_summary_row_label(std::string_view text);

/// True if a row can be a heading: none of its fields is a number. If blanks separate the fields,
/// the row must also not look like a sentence.
bool is_possible_heading_row(const std::vector<std::string_view>& fields, char separator);

}  // namespace clast
