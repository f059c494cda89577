#include "classify/dimension_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "classify/delimited_text.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

namespace clast {
namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::optional<double> number_of(std::string_view field, char separator) {
  constexpr std::size_t kLongest = 64;  // no number anyone writes is longer
  if (separator == ',' || field.find(',') == std::string_view::npos) return number_in(field);
  if (field.size() > kLongest) return std::nullopt;
  std::array<char, kLongest> text;
  std::replace_copy(field.begin(), field.end(), text.begin(), ',', '.');
  return number_in({text.data(), field.size()});
}

struct Unit {
  const char* name;
  double factor;
};
/// The micro sign stands twice in Unicode: as itself and as the Greek letter.
constexpr std::array<Unit, 9> kLengths = {{{"um", 1e-6},
                                           {"\xC2\xB5m", 1e-6},
                                           {"\xCE\xBCm", 1e-6},
                                           {"mm", 1e-3},
                                           {"cm", 1e-2},
                                           {"m", 1.0},
                                           {"km", 1e3},
                                           {"ft", 0.3048},
                                           {"in", 0.0254}}};
constexpr std::array<Unit, 4> kMasses = {
    {{"g", 1e-3}, {"kg", 1.0}, {"t", 1e3}, {"lb", 0.45359237}}};

struct ColumnName {
  std::string name;              ///< lower case, unit cut off
  const Unit* length = nullptr;  ///< where the name says it
  const Unit* mass = nullptr;
};

/// "L_m", "l (cm)", "L [mm]" and "L cm" are a name and a unit.
ColumnName column_name(std::string_view header) {
  const std::string text = lower_case(header);
  const std::size_t cut = text.find_last_of("_([ ");
  if (cut == std::string::npos || cut == 0) return {text};
  std::string ending = text.substr(cut + 1);
  while (!ending.empty() && (ending.back() == ')' || ending.back() == ']')) ending.pop_back();
  const auto unit_in = [&](std::span<const Unit> units) -> const Unit* {
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const Unit& u) { return ending == u.name; });
    return found == units.end() ? nullptr : &*found;
  };
  ColumnName column{text, unit_in(kLengths), unit_in(kMasses)};
  if (column.length || column.mass)
    column.name = text.substr(0, text.find_last_not_of("_([ ", cut) + 1);
  return column;
}

std::optional<std::size_t> column_number(const std::string& column) {
  std::size_t number = 0;
  const char* end = column.data() + column.size();
  const auto [stop, error] = std::from_chars(column.data(), end, number);
  if (error != std::errc{} || stop != end || number == 0) return std::nullopt;
  return number - 1;
}

constexpr std::array<const char*, 3> kAxisNames = {"L", "I", "S"};

/// Where the table holds what.
struct Layout {
  char separator = ',';
  bool has_header = false;
  std::array<std::size_t, 3> axes{};  ///< columns of L, I, S
  std::optional<std::size_t> mass;
  std::optional<std::size_t> name;
  double unit = 1.0;       ///< m
  double mass_unit = 1.0;  ///< kg
};

/// Finds columns by name, or by number, in the first row of a table.
class Header {
 public:
  Header(const Record& first, char separator, std::string file) : file_(std::move(file)) {
    for (const std::string_view field : first.fields) {
      fields_.emplace_back(field);
      names_.push_back(column_name(field));
    }
    is_one_ = std::none_of(first.fields.begin(), first.fields.end(), [&](std::string_view field) {
      return number_of(field, separator).has_value();
    });
  }

  bool is_one() const { return is_one_; }
  const ColumnName& name(std::size_t column) const { return names_[column]; }
  const std::string& text(std::size_t column) const { return fields_[column]; }

  std::optional<std::size_t> find(const std::string& wanted) const {
    if (!is_one_) return std::nullopt;
    const std::string name = column_name(wanted).name;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i].name == name) return i;
    }
    return std::nullopt;
  }
  std::size_t required(const std::string& wanted) const {
    if (const auto found = find(wanted)) return *found;
    if (const auto number = column_number(wanted); number && *number < fields_.size())
      return *number;
    std::string known;
    for (const std::string& field : fields_)
      known += (known.empty() ? "\"" : ", \"") + field + "\"";
    throw InputError(file_ + ": no column \"" + wanted + "\"; " +
                     (is_one_
                          ? "the header has " + known
                          : "there is no header line, so give the numbers of the columns, 1 to " +
                                std::to_string(fields_.size())));
  }

 private:
  std::string file_;
  std::vector<std::string> fields_;
  std::vector<ColumnName> names_;
  bool is_one_ = false;
};

/// The unit of L, I, S: as asked for, else as the header says, else metres.
double unit_of(const Header& header, const Layout& layout, const std::optional<double>& asked,
               const std::string& file, std::vector<std::string>& notes) {
  const Unit* named = nullptr;
  for (const std::size_t column : layout.axes) {
    const Unit* unit = header.is_one() ? header.name(column).length : nullptr;
    if (unit && named && unit->factor != named->factor) {
      throw InputError(file + ": the header names different units, " + named->name + " and " +
                       unit->name + "; write L, I and S in one unit");
    }
    if (unit) named = unit;
  }
  if (named && asked && named->factor != *asked) {
    notes.push_back(std::string("the header says ") + named->name + ", the axes were read as " +
                    with_digits(*asked, 6) + " m per unit, as asked");
  }
  if (named && !asked && named->factor != 1.0) {
    notes.push_back(std::string("axes were read in ") + named->name + ", as the header says");
  }
  return asked ? *asked : named ? named->factor : 1.0;
}

Layout layout_of(const Header& header, char separator, const DimensionColumns& columns,
                 const std::string& file, std::vector<std::string>& notes) {
  Layout layout;
  layout.separator = separator;
  layout.has_header = header.is_one();
  const std::array<const std::string*, 3> wanted = {&columns.L, &columns.I, &columns.S};
  for (int axis = 0; axis < 3; ++axis) layout.axes[axis] = header.required(*wanted[axis]);
  layout.unit = unit_of(header, layout, columns.unit, file, notes);
  layout.mass = columns.mass ? header.required(*columns.mass) : header.find("mass");
  if (layout.mass && layout.has_header && header.name(*layout.mass).mass) {
    layout.mass_unit = header.name(*layout.mass).mass->factor;
  }
  if (columns.name) {
    layout.name = header.required(*columns.name);
  } else {
    for (const char* usual : {"id", "name", "block"}) {
      if (!layout.name) layout.name = header.find(usual);
    }
  }
  return layout;
}

/// A positive number, or why there is none.
struct Cell {
  double value = 0.0;
  std::string trouble;
};

Cell positive_cell(const Record& record, std::size_t column, char separator, const char* quantity) {
  const std::string name = quantity;
  if (column >= record.fields.size() || record.fields[column].empty()) {
    return {0.0, name + " is missing"};
  }
  const std::string_view field = record.fields[column];
  const auto value = number_of(field, separator);
  if (!value) return {0.0, name + " \"" + std::string(field) + "\" is not a number"};
  if (!(*value > 0.0) || !std::isfinite(*value)) {
    return {0.0, name + " = " + std::string(field) + " is not a positive, finite number"};
  }
  return {*value, {}};
}

void read_row(const Record& record, const Layout& layout, DimensionTable& table) {
  const auto row = [&] { return "row " + std::to_string(record.line); };
  std::array<double, 3> values{};
  for (int axis = 0; axis < 3; ++axis) {
    const Cell cell = positive_cell(record, layout.axes[axis], layout.separator, kAxisNames[axis]);
    if (!cell.trouble.empty()) {
      ++table.skipped;
      table.notes.push_back(row() + " skipped: " + cell.trouble);
      return;
    }
    values[axis] = cell.value;
  }
  const auto& [L, I, S] = values;
  if (L < I || I < S) {
    ++table.sorted;
    table.notes.push_back(row() + ": axes were not in the order L >= I >= S and were sorted");
  }
  MeasuredBlock block;
  block.as_written = Axes::sorted(L, I, S);
  const Axes& sorted = block.as_written;
  block.axes = {sorted.L * layout.unit, sorted.I * layout.unit, sorted.S * layout.unit};
  if (layout.mass) {
    const Cell mass = positive_cell(record, *layout.mass, layout.separator, "mass");
    if (mass.trouble.empty()) {
      block.mass = mass.value * layout.mass_unit;
    } else {
      ++table.unweighed;
      table.notes.push_back(row() + ": " + mass.trouble + "; the block counts by number only");
    }
  }
  const bool named =
      layout.name && *layout.name < record.fields.size() && !record.fields[*layout.name].empty();
  block.name = named ? std::string(record.fields[*layout.name]) : row();
  table.blocks.push_back(std::move(block));
}

}  // namespace

DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns) {
  if (columns.unit && (!(*columns.unit > 0.0) || !std::isfinite(*columns.unit))) {
    throw InputError("unit " + with_digits(*columns.unit, 6) +
                     " m: must be positive, for example 0.01 for a table in centimetres");
  }
  const std::string file = path.string();
  const std::string content = read_text_file(path);
  DelimitedText text(content, file);
  Record record;
  if (!text.next(record)) throw InputError(file + ": the table is empty");
  const Header header(record, text.separator(), file);

  DimensionTable table;
  const Layout layout = layout_of(header, text.separator(), columns, file, table.notes);
  if (!layout.has_header) read_row(record, layout, table);
  while (text.next(record)) read_row(record, layout, table);
  if (table.blocks.empty()) {
    throw InputError(file + ": no usable row" +
                     (table.notes.empty() ? std::string() : "; " + table.notes.back()));
  }
  return table;
}

}  // namespace clast
