#include "classify/detail/table_layout.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/files/column_heading.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"

namespace clast::classify_detail {
namespace {

constexpr std::array<NamedUnit, 4> kMasses = {
    {{"g", 1e-3}, {"kg", 1.0}, {"t", 1e3}, {"lb", 0.45359237}}};

/// Words for the axes and the mass of a block, beside L, I and S.
const std::map<std::string, std::vector<std::string>, std::less<>>& words_for() {
  static const std::map<std::string, std::vector<std::string>, std::less<>> kWords = {
      {"L",
       {"l", "a", "length", "long", "longest", "major", "lange", "laenge", "langste", "laengste",
        "longueur", "lunghezza", "longitud", "largo"}},
      {"I",
       {"i", "b", "width", "intermediate", "medium", "breite", "mittlere", "largeur", "larghezza",
        "anchura", "ancho", "intermedia", "intermediaire", "intermedio"}},
      {"S", {"s",        "c",     "height",  "thickness", "short",   "shortest",
             "minor",    "depth", "hohe",    "hoehe",     "dicke",   "kurze",
             "kurzeste", "tiefe", "hauteur", "epaisseur", "altezza", "spessore",
             "altura",   "alto",  "espesor", "grosor"}},
      {"mass", {"mass", "masse", "massa", "masa", "weight", "gewicht", "poids", "peso"}}};
  return kWords;
}

struct ColumnName {
  std::string name;                 ///< lower case, unit cut off
  std::string word;                 ///< the only word of the name; empty: there are several
  std::optional<NamedUnit> length;  ///< where the name says it
  const NamedUnit* mass = nullptr;
};

ColumnName column_name(std::string_view header) {
  const ColumnHeading heading = parse_heading(header);
  ColumnName column{heading.name, heading.single_word(), heading.length_unit};
  const auto found = std::find_if(kMasses.begin(), kMasses.end(),
                                  [&](const NamedUnit& u) { return heading.unit == u.name; });
  if (found != kMasses.end()) column.mass = &*found;
  return column;
}

std::optional<std::size_t> column_number(const std::string& column) {
  std::size_t number = 0;
  const char* end = column.data() + column.size();
  const auto [stop, error] = std::from_chars(column.data(), end, number);
  if (error != std::errc{} || stop != end || number == 0) return std::nullopt;
  return number - 1;
}

/// Finds columns by name, or by number, in the first row of a table.
class Header {
 public:
  Header(const Record& first, char separator, std::string file) : file_(std::move(file)) {
    for (const std::string_view field : first.fields) {
      fields_.emplace_back(field);
      names_.push_back(column_name(field));
    }
    is_one_ = std::none_of(first.fields.begin(), first.fields.end(), [&](std::string_view field) {
      return parse_number_field(field, separator).has_value();
    });
  }

  bool is_one() const { return is_one_; }
  const ColumnName& name(std::size_t column) const { return names_[column]; }

  /// Columns that are called so: to the letter, or, where none is, but for the unit.
  std::vector<std::size_t> all(const std::string& wanted) const {
    std::vector<std::size_t> exact, found;
    if (!is_one_) return found;
    const std::string text = lower_case_ascii(wanted), name = column_name(wanted).name;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (lower_case_ascii(fields_[i]) == text) exact.push_back(i);
      if (names_[i].name == name) found.push_back(i);
    }
    if (!exact.empty()) return exact;
    const auto words = words_for().find(wanted);
    if (!found.empty() || words == words_for().end()) return found;
    const std::vector<std::string>& alike = words->second;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (std::find(alike.begin(), alike.end(), names_[i].word) != alike.end()) found.push_back(i);
    }
    return found;
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
                       "; give the number of the one you mean in `columns`");
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

/// The unit that the header names, none where it names none.
std::optional<NamedUnit> named_unit(const Header& header, const DimensionTableLayout& layout) {
  std::optional<NamedUnit> named;
  for (const std::size_t column : layout.axes) {
    const std::optional<NamedUnit> unit =
        header.is_one() ? header.name(column).length : std::nullopt;
    if (unit && named && unit->factor != named->factor) {
      throw InputError(layout.file + ": the header names different units: " + named->name +
                       " and " + unit->name + "; write L, I and S in one unit");
    }
    if (unit) named = unit;
  }
  return named;
}

/// The unit of L, I, S: as asked for, else as the header says, else metres.
void set_units(DimensionTableLayout& layout, const Header& header,
               const std::optional<double>& asked, std::vector<std::string>& notes) {
  const std::optional<NamedUnit> named = named_unit(header, layout);
  layout.units = asked ? *asked : named ? named->factor : 1.0;
  layout.units_are_known = asked || named;
  if (named && asked && named->factor != *asked) {
    notes.push_back(std::string("the header says ") + named->name + ", but the axes were read as " +
                    format_significant(*asked, 6) + " m per unit, as requested");
  }
  if (named && !asked && named->factor != 1.0) {
    notes.push_back(std::string("axes were read in ") + named->name + ", as the header says");
  }
}

/// One column can't be two quantities.
void check_columns_differ(const DimensionTableLayout& layout) {
  std::vector<std::size_t> columns(layout.axes.begin(), layout.axes.end());
  if (layout.mass) columns.push_back(*layout.mass);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (columns[i] != columns[k]) continue;
      const auto name = [](std::size_t n) { return std::string(n < 3 ? kAxisNames[n] : "mass"); };
      throw InputError(layout.file + ": column " + std::to_string(columns[i] + 1) +
                       " was given as " + name(k) + " and as " + name(i) +
                       "; each needs a column of its own");
    }
  }
}

}  // namespace

DimensionTableLayout find_dimension_table_layout(const Record& first, char separator,
                                                 const DimensionColumns& columns,
                                                 const std::string& file,
                                                 std::vector<std::string>& notes) {
  const Header header(first, separator, file);
  DimensionTableLayout layout;
  layout.file = file;
  layout.separator = separator;
  layout.has_header = header.is_one();
  const std::array<const std::string*, 3> wanted = {&columns.L, &columns.I, &columns.S};
  for (int axis = 0; axis < 3; ++axis) layout.axes[axis] = header.required(*wanted[axis]);
  if (header.is_one() && header.name(layout.axes[0]).name != column_name(columns.L).name) {
    notes.push_back("L, I and S were read from the columns \"" +
                    std::string(first.fields[layout.axes[0]]) + "\", \"" +
                    std::string(first.fields[layout.axes[1]]) + "\" and \"" +
                    std::string(first.fields[layout.axes[2]]) + "\"");
  }
  set_units(layout, header, columns.units, notes);
  layout.mass = columns.mass ? header.required(*columns.mass) : header.find("mass");
  if (layout.mass && layout.has_header && header.name(*layout.mass).mass) {
    layout.mass_units = header.name(*layout.mass).mass->factor;
  }
  if (columns.name) {
    layout.name = header.required(*columns.name);
  } else {
    for (const char* usual : {"id", "name", "block", "bloc", "blocco", "bloque"}) {
      const std::vector<std::size_t> found = header.all(usual);
      if (!layout.name && !found.empty()) layout.name = found.front();
    }
  }
  check_columns_differ(layout);
  return layout;
}

}  // namespace clast::classify_detail
