#include "classify/dimension_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "classify/detail/table_layout.hpp"
#include "core/error.hpp"
#include "core/files/column_heading.hpp"
#include "core/files/delimited_text.hpp"
#include "core/files/text_file.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"

namespace clast {

using namespace classify_detail;

namespace {

// Plausible lengths and masses. Squares and ratios of values within are far from overflow.
constexpr double kShortest = 1e-9, kLongest = 1e9;     // m
constexpr double kLightest = 1e-30, kHeaviest = 1e30;  // kg

// Longer blocks are rarer than units that were mistaken, m.
constexpr double kDoubtful = 50.0;

/// A positive number, or why there is none.
struct Cell {
  double value = 0.0;
  std::string trouble;
};

/// Allowed range of a cell, in its unit.
struct CellRange {
  double factor = 1.0;  ///< of the unit
  double low = 0.0;
  double high = 0.0;
  const char* unit = "";
};

Cell positive_cell(const Record& record, std::size_t column, const DimensionTableLayout& layout,
                   const char* quantity, const CellRange& range) {
  const std::string name = quantity;
  const std::string_view field = record.fields[column];
  if (field.empty()) return {0.0, name + " is missing"};
  if (is_ambiguous_number(field, layout.separator)) {
    throw InputError(layout.file + ":" + std::to_string(record.line) + ": " + name + " \"" +
                     std::string(field) + "\": " + kDecimalCommaHint);
  }
  const auto value = parse_number_field(field, layout.separator);
  if (!value) return {0.0, name + " \"" + std::string(field) + "\" is not a number"};
  if (!(*value > 0.0) || !std::isfinite(*value)) {
    return {0.0, name + " = " + std::string(field) + " is not a positive, finite number"};
  }
  const double size = *value * range.factor;
  if (!(size >= range.low && size <= range.high)) {
    return {0.0, name + " = " + std::string(field) + " is " + (size < range.low ? "less" : "more") +
                     " than " + format_significant(size < range.low ? range.low : range.high, 3) +
                     " " + range.unit};
  }
  return {*value, {}};
}

/// The label of a row that sums up the others: its name, or, where it has none, another text.
std::optional<std::string_view> summary_in(const Record& record,
                                           const DimensionTableLayout& layout) {
  const auto counts = [&](std::string_view field) {
    const SummaryRowLabel label = detect_summary_row_label(field);
    return label == SummaryRowLabel::kCertain ||
           (layout.has_summary && label == SummaryRowLabel::kAmbiguous);
  };
  if (layout.name && !record.fields[*layout.name].empty()) {
    const std::string_view name = record.fields[*layout.name];
    return counts(name) ? std::optional(name) : std::nullopt;
  }
  for (std::size_t i = 0; i < record.fields.size(); ++i) {
    const bool axis = std::find(layout.axes.begin(), layout.axes.end(), i) != layout.axes.end();
    if (!axis && i != layout.mass && counts(record.fields[i])) return record.fields[i];
  }
  return std::nullopt;
}

/// Finds out if rows are named means or sums in full. If so, short labels such as "SD" are
/// summaries too. In a table without names, summaries are the last rows; elsewhere such words mean
/// something else: "media" is also a degree of weathering.
void find_summary_rows(const std::string& text, DimensionTableLayout& layout) {
  DelimitedTextReader rows(text, layout.file);
  Record record;
  bool labelled = false, followed = false;
  while (rows.read_record(record)) {
    const bool summary = summary_in(record, layout).has_value();
    followed = followed || (labelled && !summary);
    labelled = labelled || summary;
    layout.has_summary = labelled;
  }
  layout.has_summary = labelled && (layout.name || !followed);
}

void read_row(const Record& record, const DimensionTableLayout& layout, DimensionTable& table) {
  const auto row = [&] { return "row " + std::to_string(record.line); };
  const auto label = layout.has_summary ? summary_in(record, layout) : std::nullopt;
  if (label) {
    ++table.skipped_rows;
    table.notes.push_back(row() + " skipped: \"" + std::string(*label) +
                          "\" is a sum of other rows");
    return;
  }
  std::array<double, 3> values{};
  for (int axis = 0; axis < 3; ++axis) {
    const Cell cell = positive_cell(record, layout.axes[axis], layout, kAxisNames[axis],
                                    {layout.units, kShortest, kLongest, "m"});
    if (!cell.trouble.empty()) {
      ++table.skipped_rows;
      table.notes.push_back(row() + " skipped: " + cell.trouble);
      return;
    }
    values[axis] = cell.value;
  }
  const auto& [L, I, S] = values;
  if (L < I || I < S) {
    ++table.reordered_rows;
    table.notes.push_back(row() + ": axes were not in the order L >= I >= S and were sorted");
  }
  MeasuredBlock block;
  block.axes_in_table_unit = Axes::sorted(L, I, S);
  const Axes& sorted = block.axes_in_table_unit;
  block.axes = {sorted.L * layout.units, sorted.I * layout.units, sorted.S * layout.units};
  if (layout.mass) {
    const Cell mass = positive_cell(record, *layout.mass, layout, "mass",
                                    {layout.mass_units, kLightest, kHeaviest, "kg"});
    if (mass.trouble.empty()) {
      block.mass = mass.value * layout.mass_units;
    } else {
      ++table.blocks_without_mass;
      table.notes.push_back(row() + ": " + mass.trouble +
                            "; the block counts by number, not by mass");
    }
  }
  const bool named = layout.name && !record.fields[*layout.name].empty();
  block.name = named ? std::string(record.fields[*layout.name]) : row();
  table.blocks.push_back(std::move(block));
}

/// Rows without a name that are the mean or the sum of those above.
void note_unnamed_summaries(DimensionTable& table) {
  constexpr double kRounding = 0.005;
  constexpr std::size_t kFewest = 3;
  std::array<double, 3> sums{}, smallest{}, largest{};
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < table.blocks.size(); ++i) {
    const Axes& axes = table.blocks[i].axes;
    const std::array<double, 3> lengths = {axes.L, axes.I, axes.S};
    const auto count = static_cast<double>(i);
    bool mean = i >= kFewest, sum = i >= kFewest;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool alike = largest[k] <= (1.0 + 2.0 * kRounding) * smallest[k];
      mean = mean && !alike && std::abs(lengths[k] - sums[k] / count) <= kRounding * lengths[k];
      sum = sum && std::abs(lengths[k] - sums[k]) <= kRounding * lengths[k];
      sums[k] += lengths[k];
      smallest[k] = i == 0 ? lengths[k] : std::min(smallest[k], lengths[k]);
      largest[k] = std::max(largest[k], lengths[k]);
    }
    const std::string& name = table.blocks[i].name;
    if ((mean || sum) && name.starts_with("row ")) {
      notes.push_back(name + " is the " + (mean ? "mean" : "sum") +
                      " of the rows above: if this row is not a block, delete it");
    }
  }
  table.notes.insert(table.notes.end(), notes.begin(), notes.end());
}

/// " (0.9 m in cm, 0.09 m in mm)": what a length would be in units that give a block or a pebble.
std::string in_other_units(double length) {
  constexpr double kPebble = 1e-3;  // m
  std::string text;
  for (const char* name : {"cm", "mm", "um"}) {
    const double factor = parse_length_unit(name);
    if (length * factor > kDoubtful || length * factor < kPebble) continue;
    text += (text.empty() ? " (" : ", ") + format_significant(length * factor, 3) + " m in " + name;
  }
  return text.empty() ? text : text + ")";
}

/// A unit that was mistaken, or a slip in single rows; empty where neither is likely.
std::string length_note(const DimensionTable& table, bool units_are_known) {
  std::vector<double> lengths;
  for (const MeasuredBlock& block : table.blocks) lengths.push_back(block.axes.L);
  std::sort(lengths.begin(), lengths.end());
  if (lengths.empty() || lengths.back() <= kDoubtful) return {};
  const double median = lengths[lengths.size() / 2];
  if (median <= kDoubtful) {
    const auto beyond = lengths.end() - std::upper_bound(lengths.begin(), lengths.end(), kDoubtful);
    return std::to_string(beyond) + (beyond == 1 ? " block is" : " blocks are") + " longer than " +
           format_significant(kDoubtful, 3) + " m, up to " + format_significant(lengths.back(), 3) +
           " m: check that these are not typing errors";
  }
  const std::string half =
      "half of the blocks are " + format_significant(median, 3) + " m long or longer";
  if (units_are_known) return half + ": check the unit, which `units` or the header gives";
  return "axes were read in metres, because neither the header nor `units` names a unit, and " +
         half + in_other_units(median) + "; give the unit as `units`";
}

}  // namespace

DimensionTable read_dimension_table(const std::filesystem::path& path,
                                    const DimensionColumns& columns) {
  if (columns.units && (!(*columns.units > 0.0) || !std::isfinite(*columns.units))) {
    throw InputError("unit " + format_significant(*columns.units, 6) +
                     " m: must be positive, for example 0.01 for a table in centimetres");
  }
  const std::string file = path.string();
  const DecodedText content = decode_table_text(read_text_file(path), file);
  DelimitedTextReader text(content.text, file);
  Record record;
  if (!text.read_record(record)) {
    throw InputError(file + ": the table is empty; it must have a line for each block");
  }
  DimensionTable table;
  if (content.from_latin1) {
    table.notes.push_back(
        "the file is not UTF-8 and was read as Windows-1252 (Latin-1); if accented letters look "
        "wrong, save it as CSV (UTF-8)");
  }
  DimensionTableLayout layout =
      find_dimension_table_layout(record, text.separator(), columns, file, table.notes);
  find_summary_rows(content.text, layout);
  if (!layout.has_header) read_row(record, layout, table);
  while (text.read_record(record)) read_row(record, layout, table);
  if (table.blocks.empty()) {
    throw InputError(file + ": no usable row" +
                     (table.notes.empty() ? std::string() : "; " + table.notes.back()));
  }
  note_unnamed_summaries(table);
  const std::string doubt = length_note(table, layout.units_are_known);
  if (!doubt.empty()) table.notes.insert(table.notes.begin(), doubt);
  return table;
}

}  // namespace clast
