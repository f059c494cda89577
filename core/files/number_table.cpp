#include "core/files/number_table.hpp"

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/files/column_heading.hpp"
#include "core/files/delimited_text.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"

namespace clast {
namespace {

bool holds_a_number(std::string_view line) {
  constexpr std::string_view kSeparators = " \t,;";
  while (true) {
    const std::size_t begin = line.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos) return false;
    line.remove_prefix(begin);
    const std::size_t length = std::min(line.find_first_of(kSeparators), line.size());
    std::string_view word = line.substr(0, length);
    if (word.size() > 1 && word.front() == '"' && word.back() == '"') {
      word = word.substr(1, word.size() - 2);
    }
    if (parse_number(word)) return true;
    line.remove_prefix(length);
  }
}

/// Detects the separator from the first line with a number, because headings may contain commas.
/// Numbers contain no blanks, so blanks and tabs are equivalent unless the first row has column
/// names separated by tabs.
char separator_of_numbers(std::string_view text) {
  bool heading_has_tabs = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    std::string_view line = text.substr(at, end - at);
    line = line.substr(0, line.find('#'));
    at = end + 1;
    if (!holds_a_number(line)) {
      heading_has_tabs = heading_has_tabs || line.find('\t') != std::string_view::npos;
      continue;
    }
    const char separator = detect_separator(line);
    return separator == '\t' && !heading_has_tabs ? ' ' : separator;
  }
  return ' ';
}

/// Columns of `names` in a heading; none where it does not have each of them.
std::optional<std::vector<std::size_t>> columns_by_name(
    const std::vector<std::string_view>& heading,
    const std::vector<std::vector<std::string>>& names) {
  std::vector<std::size_t> columns;
  for (const std::vector<std::string>& alike : names) {
    const auto field = std::find_if(heading.begin(), heading.end(), [&](std::string_view text) {
      const auto is = [&](const std::string& name) {
        return std::find(alike.begin(), alike.end(), name) != alike.end();
      };
      return is(strip_unit(text)) || is(parse_heading(text).name);
    });
    if (field == heading.end()) return std::nullopt;
    columns.push_back(static_cast<std::size_t>(field - heading.begin()));
  }
  return columns;
}

/// The columns that a heading names, none for a title.
/// @throws InputError  a heading that is none of these columns; file and line
std::optional<std::vector<std::size_t>> columns_named(const Record& heading, char separator,
                                                      const NumericTableSpec& table,
                                                      const std::string& file) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(file + ":" + std::to_string(heading.line) + ": " + problem);
  };
  std::optional<std::vector<std::size_t>> columns;
  try {
    columns = table.find_columns ? table.find_columns(heading.fields)
                                 : columns_by_name(heading.fields, table.column_names);
  } catch (const InputError& error) {
    refuse(error.what());
  }
  if (!columns) {
    if (heading.fields.size() != table.column_names.size() ||
        !is_possible_heading_row(heading.fields, separator)) {
      return std::nullopt;
    }
    refuse("its heading does not name the columns; each line must be " + table.expected_line +
           "; give the columns these names");
  }
  for (const std::size_t column : *columns) {
    const ColumnHeading name = parse_heading(heading.fields[column]);
    if (name.length_unit && name.length_unit->factor != 1.0) {
      refuse("\"" + escape_nonprintable(heading.fields[column]) + "\" is in " +
             name.length_unit->name + "; lengths of this table must be in m");
    }
  }
  return columns;
}

/// The numbers of a row, and what is wrong with it.
class RowReader {
 public:
  RowReader(const std::string& name, const NumericTableSpec& table, char separator)
      : name_(name), table_(table), separator_(separator) {}

  bool has_numbers(const Record& record) const {
    return std::any_of(record.fields.begin(), record.fields.end(),
                       [&](std::string_view f) { return parse_number_field(f, separator_); });
  }

  void check_count(const Record& record, std::size_t fields) const {
    const std::size_t count = record.fields.size();
    if (count == fields) return;
    refuse(record, std::to_string(count) + (count == 1 ? " number" : " numbers") +
                       (separator_ == ',' ? "; " + std::string(kDecimalCommaHint) : ""));
  }

  double number(const Record& record, std::size_t column) const {
    const std::string_view field = record.fields[column];
    const std::optional<double> value = parse_number_field(field, separator_);
    if (!value) {
      refuse(record,
             "\"" + std::string(field.substr(0, 40)) + "\" is not a number" +
                 (is_ambiguous_number(field, separator_) ? "; " + std::string(kDecimalCommaHint)
                                                         : ""));
    }
    if (!table_.range.contains(*value)) {
      refuse(record, std::string(field) + " is not a number " + table_.range.describe());
    }
    return *value;
  }

 private:
  [[noreturn]] void refuse(const Record& record, const std::string& problem) const {
    throw InputError(name_ + ":" + std::to_string(record.line) + ": " + problem +
                     "; a line must be " + table_.expected_line);
  }

  const std::string& name_;
  const NumericTableSpec& table_;
  char separator_;
};

}  // namespace

std::string strip_unit(std::string_view field) {
  std::string name;
  for (const char c : field) {
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (name.ends_with("_m")) name.resize(name.size() - 2);
  return name;
}

std::vector<NumericRow> read_numeric_table(const std::filesystem::path& file,
                                           const NumericTableSpec& table) {
  const std::string name = file.string();
  const DecodedText content = decode_table_text(read_text_file(file), name);
  DelimitedTextReader text(content.text, name,
                           {.separator = separator_of_numbers(content.text),
                            .inline_comments = true,
                            .any_heading_width = true});
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.column_names.size(); ++i) columns.push_back(i);
  std::size_t fields = columns.size();
  const RowReader reader(name, table, text.separator());
  std::vector<NumericRow> rows;
  Record record;
  for (std::size_t row = 0; text.read_record(record); ++row) {
    if (row == 0 && !reader.has_numbers(record)) {
      if (const auto named = columns_named(record, text.separator(), table, name)) {
        columns = *named;
        fields = record.fields.size();
      }
      continue;
    }
    reader.check_count(record, fields);
    if (detect_summary_row_label(record.fields.front()) == SummaryRowLabel::kCertain) {
      throw InputError(name + ":" + std::to_string(record.line) + ": \"" +
                       escape_nonprintable(record.fields.front()) +
                       "\" is a sum of other rows; remove that row");
    }
    NumericRow& read = rows.emplace_back(NumericRow{record.line, {}});
    for (const std::size_t column : columns) read.values.push_back(reader.number(record, column));
  }
  if (rows.empty()) {
    throw InputError(name + ": has no line of numbers; each line must be " + table.expected_line);
  }
  return rows;
}

}  // namespace clast
