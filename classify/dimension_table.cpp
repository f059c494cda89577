#include "classify/dimension_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

namespace clast {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

struct Line {
  std::size_t number;
  std::string text;
};

/// Lines with something on them; lines that start with # are remarks.
std::vector<Line> lines_of(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!trimmed(line).empty() && trimmed(line).front() != '#') {
      lines.push_back({number, std::string(line)});
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Semicolons or tabs leave the comma free to be a decimal sign.
char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return ' ';
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::string field;
  bool quoted = false;
  const auto finish = [&] {
    const std::string_view content = trimmed(field);
    if (separator != ' ' || !content.empty()) fields.emplace_back(content);
    field.clear();
  };
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == separator || (separator == ' ' && c == '\t'))) {
      finish();
    } else {
      field += c;
    }
  }
  finish();
  return fields;
}

std::optional<double> number_of(std::string field, char separator) {
  if (separator != ',') std::replace(field.begin(), field.end(), ',', '.');
  return number_in(field);
}

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits = {
    {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"ft", 0.3048}, {"in", 0.0254}}};

struct ColumnName {
  std::string name;            ///< lower case, unit cut off
  std::optional<double> unit;  ///< metres, where the name says it
};

/// "L_m", "l (cm)", "L [mm]" and "L cm" are a name and a unit.
ColumnName column_name(const std::string& header) {
  const std::string text = lower_case(trimmed(header));
  const std::size_t cut = text.find_last_of("_([ ");
  if (cut == std::string::npos || cut == 0) return {text, std::nullopt};
  std::string ending = text.substr(cut + 1);
  while (!ending.empty() && (ending.back() == ')' || ending.back() == ']')) ending.pop_back();
  for (const Unit& unit : kUnits) {
    if (ending != unit.name) continue;
    return {std::string(trimmed(std::string_view(text).substr(0, cut))), unit.metres};
  }
  return {text, std::nullopt};
}

std::optional<std::size_t> column_number(const std::string& column) {
  std::size_t number = 0;
  const char* end = column.data() + column.size();
  const auto [stop, error] = std::from_chars(column.data(), end, number);
  if (error != std::errc{} || stop != end || number == 0) return std::nullopt;
  return number - 1;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return text;
}

/// Where the table holds what.
struct Layout {
  char separator = ',';
  bool has_header = false;
  std::array<std::size_t, 3> axes{};  ///< columns of L, I, S
  std::optional<std::size_t> mass;
  std::optional<std::size_t> name;
  std::optional<double> named_unit;
};

Layout layout_of(const std::string& first_line, const DimensionColumns& columns,
                 const std::string& file) {
  Layout layout;
  layout.separator = separator_of(first_line);
  const std::vector<std::string> fields = fields_of(first_line, layout.separator);
  std::vector<ColumnName> names;
  for (const std::string& field : fields) names.push_back(column_name(field));
  layout.has_header = std::none_of(fields.begin(), fields.end(), [&](const std::string& field) {
    return number_of(field, layout.separator).has_value();
  });

  const auto column = [&](const std::string& wanted) -> std::size_t {
    const std::string name = column_name(wanted).name;
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const ColumnName& c) { return c.name == name; });
    if (layout.has_header && found != names.end()) {
      return static_cast<std::size_t>(found - names.begin());
    }
    if (const auto number = column_number(wanted); number && *number < fields.size()) {
      return *number;
    }
    throw InputError(file + ": no column \"" + wanted + "\"; " +
                     (layout.has_header
                          ? "the header has " + joined(fields)
                          : "there is no header line, so give the numbers of the columns, 1 to " +
                                std::to_string(fields.size())));
  };
  const std::array<std::string, 3> wanted = {columns.L, columns.I, columns.S};
  for (int axis = 0; axis < 3; ++axis) {
    layout.axes[axis] = column(wanted[axis]);
    const ColumnName& name = names[layout.axes[axis]];
    if (layout.has_header && name.unit) layout.named_unit = name.unit;
  }
  if (!columns.mass.empty()) layout.mass = column(columns.mass);
  for (std::size_t i = 0; layout.has_header && i < names.size() && !layout.name; ++i) {
    const std::string& name = names[i].name;
    if (name == "id" || name == "name" || name == "block") layout.name = i;
  }
  return layout;
}

/// The numbers of a row as written, or why it can't be used.
struct Row {
  std::array<double, 3> axes{};
  std::optional<double> mass;
  std::string trouble;
};

Row row_of(const std::vector<std::string>& fields, const Layout& layout) {
  Row row;
  const auto positive = [&](std::size_t column, const std::string& name, const char* what) {
    double value = 0.0;
    if (column >= fields.size() || fields[column].empty()) {
      row.trouble = name + " is missing";
    } else if (const auto number = number_of(fields[column], layout.separator); !number) {
      row.trouble = name + " \"" + fields[column] + "\" is not a number";
    } else if (!(*number > 0.0) || !std::isfinite(*number)) {
      row.trouble = name + " = " + fields[column] + " is not a " + what;
    } else {
      value = *number;
    }
    return value;
  };
  constexpr std::array<const char*, 3> kNames = {"L", "I", "S"};
  for (int axis = 0; axis < 3 && row.trouble.empty(); ++axis) {
    row.axes[axis] = positive(layout.axes[axis], kNames[axis], "length");
  }
  if (layout.mass && row.trouble.empty()) row.mass = positive(*layout.mass, "mass", "mass");
  return row;
}

}  // namespace

DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns) {
  if (!(columns.unit > 0.0) || !std::isfinite(columns.unit)) {
    throw InputError("unit " + std::to_string(columns.unit) +
                     " m: must be positive, for example 0.01 for a table in centimetres");
  }
  const std::string file = path.string();
  const std::vector<Line> lines = lines_of(read_text_file(path));
  if (lines.empty()) throw InputError(file + ": the table is empty");
  const Layout layout = layout_of(lines.front().text, columns, file);

  DimensionTable table;
  if (layout.named_unit && *layout.named_unit != columns.unit) {
    std::ostringstream note;
    note << "the header names units of " << *layout.named_unit << " m, read as " << columns.unit
         << " m per unit; classes don't depend on it";
    table.notes.push_back(note.str());
  }
  for (std::size_t i = layout.has_header ? 1 : 0; i < lines.size(); ++i) {
    const std::string row = "row " + std::to_string(lines[i].number);
    const std::vector<std::string> fields = fields_of(lines[i].text, layout.separator);
    const Row read = row_of(fields, layout);
    if (!read.trouble.empty()) {
      table.notes.push_back(row + " skipped: " + read.trouble);
      ++table.skipped;
      continue;
    }
    const auto& [L, I, S] = read.axes;
    if (L < I || I < S) {
      table.notes.push_back(row + ": axes were not in the order L >= I >= S and were sorted");
    }
    const bool named = layout.name && *layout.name < fields.size() && !fields[*layout.name].empty();
    table.blocks.push_back({named ? fields[*layout.name] : row,
                            Axes::sorted(L * columns.unit, I * columns.unit, S * columns.unit),
                            read.mass});
  }
  if (table.blocks.empty()) {
    throw InputError(file + ": no usable row" +
                     (table.notes.empty() ? std::string() : "; " + table.notes.back()));
  }
  return table;
}

}  // namespace clast
