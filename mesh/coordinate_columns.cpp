#include "mesh/coordinate_columns.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "core/error.hpp"
#include "core/files/column_heading.hpp"
#include "core/printable.hpp"

namespace clast {
namespace {

using WordSet = std::set<std::string, std::less<>>;

/// Names of an axis: the letter, and the words of surveyors.
struct AxisWords {
  WordSet letters, words;
};

const std::array<AxisWords, 3>& axis_words() {
  static const std::array<AxisWords, 3> kWords = {
      {{{"x", "xcoord", "coordx", "xkoord", "px"},
        {"e", "easting", "eastings", "east", "rechtswert", "rechts", "rw", "ostwert", "ost", "est",
         "este", "abscisse", "ascissa", "abscisa"}},
       {{"y", "ycoord", "coordy", "ykoord", "py"},
        {"n", "northing", "northings", "north", "hochwert", "hoch", "hw", "nordwert", "nord",
         "norte", "ordonnee", "ordinata", "ordenada"}},
       {{"z", "zcoord", "coordz", "zkoord", "pz"},
        {"h",        "height",     "heights",     "elevation",   "elevations",    "elev",
         "altitude", "altitudes",  "alt",         "hoehe",       "hohe",          "hoehen",
         "hohen",    "meereshohe", "meereshoehe", "gelandehohe", "gelaendehoehe", "hauteur",
         "cote",     "quota",      "altezza",     "altitudine",  "elevazione",    "altura",
         "cota",     "altitud",    "elevacion"}}}};
  return kWords;
}

bool names_degrees(const ColumnHeading& heading) {
  static const WordSet kWords = {"longitude", "lon",     "lng",         "latitude",  "lat",
                                 "longitud",  "latitud", "longitudine", "latitudine"};
  return kWords.contains(heading.single_word());
}

/// "Points:0", "Points_1", "Point[2]": the components of the points of ParaView.
std::optional<int> component(std::string_view heading, const std::string& word) {
  std::string lower;
  for (const char c : heading) {
    if (c != '"') lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (!lower.starts_with("point") || word.size() != 1 || word[0] < '0' || word[0] > '2') return {};
  return word[0] - '0';
}

enum class AxisName { kNone, kLetter, kWord };

struct NamedAxis {
  int axis = -1;
  AxisName name = AxisName::kNone;
};

NamedAxis named_axis(std::string_view text, const ColumnHeading& heading) {
  const std::string word = heading.single_word();
  if (const auto axis = component(text, word)) return {*axis, AxisName::kLetter};
  for (int axis = 0; axis < 3; ++axis) {
    const AxisWords& known = axis_words()[static_cast<std::size_t>(axis)];
    if (known.letters.contains(word)) return {axis, AxisName::kLetter};
    if (known.words.contains(word)) return {axis, AxisName::kWord};
  }
  return {};
}

/// Units that the headings of the columns name.
std::vector<LengthUnitDeclaration> declared_by(const std::vector<std::string_view>& headings,
                                               const std::array<std::size_t, 3>& axes) {
  std::vector<LengthUnitDeclaration> lengths;
  for (std::size_t axis = 0; axis < 3 && axes[axis] < headings.size(); ++axis) {
    const ColumnHeading heading = parse_heading(headings[axes[axis]]);
    if (heading.unit.empty() && heading.bracketed_text.empty()) continue;
    LengthUnitDeclaration declared{.source = "heading \"" +
                                             escape_nonprintable(headings[axes[axis]]) + "\""};
    if (heading.unit.empty()) {
      declared.kind = ReferenceSystemKind::kUnknown;
    } else if (heading.length_unit) {
      (axis < 2 ? declared.plan : declared.height) =
          DeclaredUnit{heading.length_unit->factor, heading.length_unit->name};
    } else {
      declared.kind = ReferenceSystemKind::kGeographic;
    }
    lengths.push_back(std::move(declared));
  }
  return lengths;
}

}  // namespace

std::optional<int> parse_coordinate_axis(std::string_view heading) {
  const NamedAxis named = named_axis(heading, parse_heading(heading));
  return named.name == AxisName::kNone ? std::nullopt : std::optional(named.axis);
}

std::optional<CoordinateColumns> find_coordinate_columns(
    const std::vector<std::string_view>& headings) {
  std::array<std::vector<std::size_t>, 3> letters, words;
  std::size_t degrees = 0;
  for (std::size_t column = 0; column < headings.size(); ++column) {
    const ColumnHeading heading = parse_heading(headings[column]);
    if (names_degrees(heading)) ++degrees;
    const NamedAxis named = named_axis(headings[column], heading);
    if (named.name == AxisName::kNone) continue;
    (named.name == AxisName::kLetter ? letters : words)[static_cast<std::size_t>(named.axis)]
        .push_back(column);
  }
  const auto& plan = !letters[0].empty() || !letters[1].empty() ? letters : words;
  const std::vector<std::size_t>& height = !letters[2].empty() ? letters[2] : words[2];
  if (plan[0].size() == 1 && plan[1].size() == 1 && height.size() == 1) {
    CoordinateColumns found{.axes = {plan[0][0], plan[1][0], height[0]}};
    found.unit_declarations = declared_by(headings, found.axes);
    return found;
  }
  if (degrees >= 2) {
    throw InputError(
        "its columns are longitude and latitude, in degrees; project them to metres first, for "
        "example with gdaltransform -t_srs EPSG:CODE");
  }
  return std::nullopt;
}

CoordinateColumns select_coordinate_columns(const std::vector<std::string>& columns,
                                            const std::vector<std::string_view>& headings,
                                            std::size_t fields) {
  if (columns.size() != 3) {
    throw InputError("`columns` must be three names or numbers from 1, those of x, y and z, not " +
                     std::to_string(columns.size()));
  }
  CoordinateColumns chosen;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string& wanted = columns[axis];
    std::vector<std::size_t> found;
    for (std::size_t column = 0; column < headings.size(); ++column) {
      const ColumnHeading heading = parse_heading(headings[column]);
      if (headings[column] == wanted || heading.name == parse_heading(wanted).name) {
        found.push_back(column);
      }
    }
    std::size_t number = 0;
    const char* end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, number);
    if (found.empty() && error == std::errc{} && stop == end && number >= 1 && number <= fields) {
      found = {number - 1};
    }
    if (found.size() != 1) {
      throw InputError(
          "`columns`: " + std::string(found.empty() ? "no column" : "several columns") + " \"" +
          escape_nonprintable(wanted) +
          "\"; give names of its heading or numbers from 1 "
          "to " +
          std::to_string(fields));
    }
    chosen.axes[axis] = found[0];
  }
  if (chosen.axes[0] == chosen.axes[1] || chosen.axes[1] == chosen.axes[2] ||
      chosen.axes[0] == chosen.axes[2]) {
    throw InputError("`columns`: one column can't be two axes; give three different ones");
  }
  chosen.unit_declarations = declared_by(headings, chosen.axes);
  return chosen;
}

}  // namespace clast
