#include "classify/dimension_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "core/delimited_text.hpp"
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
  std::string file;
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
      return number_in_field(field, separator).has_value();
    });
  }

  bool is_one() const { return is_one_; }
  const ColumnName& name(std::size_t column) const { return names_[column]; }
  const std::string& text(std::size_t column) const { return fields_[column]; }

  /// Columns that are called so: to the letter, or, where none is, but for the unit.
  std::vector<std::size_t> all(const std::string& wanted) const {
    std::vector<std::size_t> exact, found;
    if (!is_one_) return found;
    const std::string text = lower_case(wanted), name = column_name(wanted).name;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (lower_case(fields_[i]) == text) exact.push_back(i);
      if (names_[i].name == name) found.push_back(i);
    }
    return exact.empty() ? found : exact;
  }
  std::optional<std::size_t> find(const std::string& wanted) const {
    const std::vector<std::size_t> found = all(wanted);
    if (found.size() > 1) {
      std::string numbers;
      for (const std::size_t column : found) {
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(column + 1);
      }
      throw InputError(file_ + ": " + std::to_string(found.size()) + " columns are called \"" +
                       wanted + "\", numbers " + numbers +
                       "; give the number of the one you mean in --columns");
    }
    if (found.empty()) return std::nullopt;
    return found.front();
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

/// One column can't be two quantities.
void check_columns_differ(const Layout& layout, const std::string& file) {
  std::vector<std::size_t> columns(layout.axes.begin(), layout.axes.end());
  if (layout.mass) columns.push_back(*layout.mass);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (columns[i] != columns[k]) continue;
      const auto name = [](std::size_t n) { return std::string(n < 3 ? kAxisNames[n] : "mass"); };
      throw InputError(file + ": column " + std::to_string(columns[i] + 1) + " was given as " +
                       name(k) + " and as " + name(i) + "; each needs a column of its own");
    }
  }
}

Layout layout_of(const Header& header, char separator, const DimensionColumns& columns,
                 const std::string& file, std::vector<std::string>& notes) {
  Layout layout;
  layout.file = file;
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
      const std::vector<std::size_t> found = header.all(usual);
      if (!layout.name && !found.empty()) layout.name = found.front();
    }
  }
  check_columns_differ(layout, file);
  return layout;
}

// What is outside is no block and no mass of one; squares and ratios of what is inside stay far
// from the ends of a double.
constexpr double kShortest = 1e-9, kLongest = 1e9;     // m
constexpr double kLightest = 1e-30, kHeaviest = 1e30;  // kg

// Longer blocks are rarer than units that were mistaken, m.
constexpr double kDoubtful = 50.0;

/// A positive number, or why there is none.
struct Cell {
  double value = 0.0;
  std::string trouble;
};

/// How much a cell may hold in its unit.
struct CellRange {
  double factor = 1.0;  ///< of the unit
  double low = 0.0;
  double high = 0.0;
  const char* unit = "";
};

Cell positive_cell(const Record& record, std::size_t column, const Layout& layout,
                   const char* quantity, const CellRange& range) {
  const std::string name = quantity;
  const std::string_view field = record.fields[column];
  if (field.empty()) return {0.0, name + " is missing"};
  if (is_doubtful_number(field, layout.separator)) {
    throw InputError(layout.file + ":" + std::to_string(record.line) + ": " + name + " \"" +
                     std::string(field) + "\": " + kDecimalCommaAdvice);
  }
  const auto value = number_in_field(field, layout.separator);
  if (!value) return {0.0, name + " \"" + std::string(field) + "\" is not a number"};
  if (!(*value > 0.0) || !std::isfinite(*value)) {
    return {0.0, name + " = " + std::string(field) + " is not a positive, finite number"};
  }
  const double size = *value * range.factor;
  if (!(size >= range.low && size <= range.high)) {
    return {0.0, name + " = " + std::string(field) + " is " + (size < range.low ? "less" : "more") +
                     " than " + with_digits(size < range.low ? range.low : range.high, 3) + " " +
                     range.unit};
  }
  return {*value, {}};
}

void read_row(const Record& record, const Layout& layout, DimensionTable& table) {
  const auto row = [&] { return "row " + std::to_string(record.line); };
  std::array<double, 3> values{};
  for (int axis = 0; axis < 3; ++axis) {
    const Cell cell = positive_cell(record, layout.axes[axis], layout, kAxisNames[axis],
                                    {layout.unit, kShortest, kLongest, "m"});
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
    const Cell mass = positive_cell(record, *layout.mass, layout, "mass",
                                    {layout.mass_unit, kLightest, kHeaviest, "kg"});
    if (mass.trouble.empty()) {
      block.mass = mass.value * layout.mass_unit;
    } else {
      ++table.unweighed;
      table.notes.push_back(row() + ": " + mass.trouble + "; the block counts by number only");
    }
  }
  const bool named = layout.name && !record.fields[*layout.name].empty();
  block.name = named ? std::string(record.fields[*layout.name]) : row();
  table.blocks.push_back(std::move(block));
}

/// " (0.9 m in cm, 0.09 m in mm)": what a length would be in units that give a block or a pebble.
std::string in_other_units(double length) {
  constexpr double kPebble = 1e-3;  // m
  std::string text;
  for (const auto& [name, factor] : {Unit{"cm", 1e-2}, Unit{"mm", 1e-3}, Unit{"um", 1e-6}}) {
    if (length * factor > kDoubtful || length * factor < kPebble) continue;
    text += (text.empty() ? " (" : ", ") + with_digits(length * factor, 3) + " m in " + name;
  }
  return text.empty() ? text : text + ")";
}

/// A unit that was mistaken, or a slip in single rows; empty where neither is likely.
std::string length_note(const DimensionTable& table, bool unit_is_known) {
  std::vector<double> lengths;
  for (const MeasuredBlock& block : table.blocks) lengths.push_back(block.axes.L);
  std::sort(lengths.begin(), lengths.end());
  if (lengths.empty() || lengths.back() <= kDoubtful) return {};
  const double median = lengths[lengths.size() / 2];
  if (median <= kDoubtful) {
    const auto beyond = lengths.end() - std::upper_bound(lengths.begin(), lengths.end(), kDoubtful);
    return std::to_string(beyond) + (beyond == 1 ? " block is" : " blocks are") + " longer than " +
           with_digits(kDoubtful, 3) + " m, up to " + with_digits(lengths.back(), 3) +
           " m: are these slips of the pen?";
  }
  const std::string half = "half of the blocks are " + with_digits(median, 3) + " m long or longer";
  if (unit_is_known) return half + ": check the unit, which is as --units or the header says";
  return "axes were read in metres, as neither the header nor --units names a unit, and " + half +
         in_other_units(median) + "; give the unit with --units";
}

}  // namespace

DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns) {
  if (columns.unit && (!(*columns.unit > 0.0) || !std::isfinite(*columns.unit))) {
    throw InputError("unit " + with_digits(*columns.unit, 6) +
                     " m: must be positive, for example 0.01 for a table in centimetres");
  }
  const std::string file = path.string();
  const TableText content = table_text(read_text_file(path), file);
  DelimitedText text(content.text, file);
  Record record;
  if (!text.next(record)) {
    throw InputError(file + ": the table is empty; it must have a line for each block");
  }
  const Header header(record, text.separator(), file);

  DimensionTable table;
  if (content.from_latin1) {
    table.notes.push_back(
        "the file is not UTF-8 and was read as Windows-1252 (Latin-1); where letters with accents "
        "look wrong, save it as CSV (UTF-8)");
  }
  const Layout layout = layout_of(header, text.separator(), columns, file, table.notes);
  if (!layout.has_header) read_row(record, layout, table);
  while (text.next(record)) read_row(record, layout, table);
  if (table.blocks.empty()) {
    throw InputError(file + ": no usable row" +
                     (table.notes.empty() ? std::string() : "; " + table.notes.back()));
  }
  const bool unit_is_known =
      columns.unit.has_value() ||
      std::any_of(layout.axes.begin(), layout.axes.end(), [&](std::size_t column) {
        return header.is_one() && header.name(column).length != nullptr;
      });
  const std::string doubt = length_note(table, unit_is_known);
  if (!doubt.empty()) table.notes.insert(table.notes.begin(), doubt);
  return table;
}

}  // namespace clast
