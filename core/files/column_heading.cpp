#include "core/files/column_heading.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "core/files/delimited_text.hpp"
#include "core/utf8.hpp"

namespace clast {
namespace {

/// Lengths beside `kLengthUnits`.
constexpr std::array<NamedUnit, 24> kMoreLengths = {{{"metre", 1.0},
                                                     {"metres", 1.0},
                                                     {"meter", 1.0},
                                                     {"meters", 1.0},
                                                     {"metri", 1.0},
                                                     {"metro", 1.0},
                                                     {"metros", 1.0},
                                                     {"dm", 0.1},
                                                     {"centimetre", 0.01},
                                                     {"centimetres", 0.01},
                                                     {"centimeter", 0.01},
                                                     {"centimeters", 0.01},
                                                     {"millimetre", 0.001},
                                                     {"millimetres", 0.001},
                                                     {"millimeter", 0.001},
                                                     {"millimeters", 0.001},
                                                     {"foot", 0.3048},
                                                     {"feet", 0.3048},
                                                     {"usft", 1200.0 / 3937.0},
                                                     {"ftus", 1200.0 / 3937.0},
                                                     {"us-ft", 1200.0 / 3937.0},
                                                     {"inch", 0.0254},
                                                     {"inches", 0.0254},
                                                     {"yd", 0.9144}}};

/// Feet and inches in German, French, Italian and Spanish, and their signs. They count in brackets
/// alone: "Kote Fuss" is the level of a foot.
constexpr std::array<NamedUnit, 20> kBracketedLengths = {{{"'", 0.3048},
                                                          {"\xE2\x80\xB2", 0.3048},
                                                          {"fuss", 0.3048},
                                                          {"fu\xC3\x9F", 0.3048},
                                                          {"pied", 0.3048},
                                                          {"pieds", 0.3048},
                                                          {"piede", 0.3048},
                                                          {"piedi", 0.3048},
                                                          {"pie", 0.3048},
                                                          {"pies", 0.3048},
                                                          {"''", 0.0254},
                                                          {"\"", 0.0254},
                                                          {"\xE2\x80\xB3", 0.0254},
                                                          {"zoll", 0.0254},
                                                          {"pouce", 0.0254},
                                                          {"pouces", 0.0254},
                                                          {"pollice", 0.0254},
                                                          {"pollici", 0.0254},
                                                          {"pulgada", 0.0254},
                                                          {"pulgadas", 0.0254}}};

const std::set<std::string, std::less<>>& empty_words() {
  static const std::set<std::string, std::less<>> kWords = {
      "coordinate", "coordinates", "coord",       "coords",     "koordinate", "koordinaten",
      "koord",      "coordonnee",  "coordonnees", "coordinata", "coordenada", "coordenadas",
      "point",      "points",      "punkt",       "punkte",     "punto",      "punti",
      "puntos",     "pos",         "position",    "posizione",  "posicion",   "wert",
      "werte",      "value",       "valeur",      "valore",     "valor",      "axis",
      "achse",      "axe",         "asse",        "eje",        "utm",        "map",
      "of",         "in",          "the",         "der",        "de",         "del",
      "di",         "du",          "la",          "le",         "en"};
  return kWords;
}

/// Lower case, with letters of Latin-1 by their ASCII letter; other characters stay.
std::string plain_lower(std::string_view text) {
  // Base letters of U+00E0 to U+00FF (capitals are 32 lower); a blank if there is none. Sharp s is
  // at 0xDF, y with diaeresis at 0xFF.
  constexpr std::string_view kLetters = "aaaaaaaceeeeiiiidnooooo ouuuuypy";
  std::string plain;
  const std::string utf8 = to_utf8(text);
  for (std::string_view rest = utf8; !rest.empty();) {
    const DecodedCharacter character = decode_first_character(rest);
    const std::string_view bytes = rest.substr(0, std::max<std::size_t>(character.length, 1));
    rest.remove_prefix(bytes.size());
    if (character.code < 0x80) {
      plain += static_cast<char>(std::tolower(static_cast<int>(character.code)));
    } else if (character.code >= 0xC0 && character.code <= 0xDF) {
      plain += character.code == 0xDF ? 's' : kLetters[character.code - 0xC0];
    } else if (character.code >= 0xE0 && character.code <= 0xFF) {
      plain += kLetters[character.code - 0xE0];
    } else if (character.code < 0x300 || character.code > 0x36F) {  // no accent of its own
      plain += bytes;
    }
  }
  return plain;
}

std::string ascii_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string_view without(std::string_view text, std::string_view ends) {
  const std::size_t begin = text.find_first_not_of(ends);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(ends) - begin + 1);
}

std::optional<NamedUnit> length_named(std::string_view word, bool in_brackets) {
  for (const NamedUnit& unit : kLengthUnits) {
    if (word == unit.name) return unit;
  }
  for (const NamedUnit& unit : kMoreLengths) {
    if (word == unit.name) return unit;
  }
  if (!in_brackets) return std::nullopt;
  for (const NamedUnit& unit : kBracketedLengths) {
    if (word == unit.name) return unit;
  }
  return std::nullopt;
}

bool is_other_unit(std::string_view word) {
  constexpr std::array<std::string_view, 12> kUnits = {
      "deg", "degree", "degrees", "\xC2\xB0", "grad", "gon", "rad", "g", "kg", "t", "lb", "%"};
  return std::find(kUnits.begin(), kUnits.end(), word) != kUnits.end();
}

/// Splits at all but letters and digits, and where a capital follows a small letter: "PointX".
std::vector<std::string> words_of(std::string_view text) {
  std::string spaced;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool capital = text[i] >= 'A' && text[i] <= 'Z';
    if (capital && i > 0 && text[i - 1] >= 'a' && text[i - 1] <= 'z') spaced += ' ';
    spaced += text[i];
  }
  std::vector<std::string> words;
  std::string word;
  const auto end = [&] {
    if (!word.empty()) words.push_back(std::move(word));
    word.clear();
  };
  for (const char c : plain_lower(spaced)) {
    const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
    if (part) {
      word += c;
    } else {
      end();
    }
  }
  end();
  return words;
}

}  // namespace

ColumnHeading parse_heading(std::string_view field) {
  constexpr std::string_view kBlank = " \t\"'";
  const std::string lower = ascii_lower(without(field, kBlank));
  ColumnHeading heading{
      .name = lower, .words = {}, .length_unit = {}, .unit = {}, .bracketed_text = {}};
  std::string_view rest = without(field, kBlank);
  // The unit is what stands in brackets at the end, or behind the last blank, comma, slash or _.
  constexpr std::string_view kBefore = "_([{<,;/ ", kAfter = ")]}> .";
  const bool closed =
      std::string_view(")]}>").find(lower.empty() ? ' ' : lower.back()) != std::string_view::npos;
  const std::size_t cut = lower.find_last_of(closed ? "([{<" : "_([{<,/ ");
  if (cut != std::string::npos && cut > 0) {
    const std::string ending(without(std::string_view(lower).substr(cut + 1), kAfter));
    const bool in_brackets = std::string_view("([{<").find(lower[cut]) != std::string_view::npos;
    heading.length_unit = length_named(ending, in_brackets);
    if (in_brackets && !heading.length_unit) {  // "[m above sea level]"
      heading.length_unit = length_named(ending.substr(0, ending.find(' ')), true);
    }
    if (in_brackets) heading.bracketed_text = ending;
    if (heading.length_unit || is_other_unit(ending)) {
      heading.unit = ending;
      const std::size_t last = lower.find_last_not_of(kBefore, cut);
      heading.name = lower.substr(0, last + 1);
      rest = rest.substr(0, last + 1);
      // "X in m", "X en metros"
      for (const std::string_view link : {" in", " en"}) {
        if (!heading.name.ends_with(link)) continue;
        heading.name.resize(heading.name.size() - link.size());
        rest.remove_suffix(link.size());
      }
    }
  }
  std::vector<std::string> words = words_of(rest);
  std::vector<std::string> telling;
  for (const std::string& word : words) {
    if (!empty_words().contains(word)) telling.push_back(word);
  }
  heading.words = telling.empty() ? std::move(words) : std::move(telling);
  return heading;
}

std::string ColumnHeading::snake_case() const {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "_") + word;
  return text;
}

namespace {

/// Signs of means and standard deviations, and "25%" or "75 %".
bool is_summary_sign(std::string_view text) {
  const std::string_view sign = without(text, " .:");
  constexpr std::array<std::string_view, 7> kSigns = {
      "\xE2\x88\x85", "\xC3\x98", "\xC3\xB8", "\xCF\x83", "\xCE\xA3", "\xCE\xBC", "\xE2\x88\x91"};
  if (std::find(kSigns.begin(), kSigns.end(), sign) != kSigns.end()) return true;
  if (!sign.ends_with('%')) return false;
  const std::string_view number = without(sign.substr(0, sign.size() - 1), " ");
  return !number.empty() && number.find_first_not_of("0123456789.,") == std::string_view::npos;
}

}  // namespace

SummaryRowLabel detect_summary_row_label(std::string_view text) {
  static const std::set<std::string> kLabels = {
      // count, sum
      "n", "count", "anzahl", "nombre", "effectif", "numero", "total", "totals", "sum", "summe",
      "gesamt", "gesamtsumme", "insgesamt", "grand total", "somme", "totale", "somma", "totali",
      "suma", "subtotal", "total general",
      // mean, median
      "mean", "average", "avg", "arithmetic mean", "geometric mean", "mean value", "median",
      "mittel", "mittelwert", "mw", "durchschnitt", "schnitt", "arithmetisches mittel", "moyenne",
      "moy", "mediane", "media", "mediana", "promedio", "prom", "valore medio", "valor medio",
      "valeur moyenne", "media aritmetica", "moyenne arithmetique", "mode", "modus", "moda",
      // spread
      "sd", "std", "stdev", "st dev", "std dev", "stddev", "s d", "standard deviation",
      "standard error", "se", "sem", "cv", "coefficient of variation", "variance", "var", "sigma",
      "stabw", "standardabweichung", "std abw", "streuung", "varianz", "variationskoeffizient",
      "ecart type", "ecarttype", "e t", "deviazione standard", "dev st", "dev std", "scarto",
      "scarto quadratico medio", "varianza", "desviacion estandar", "desviacion tipica", "desv est",
      "desvest", "de", "s", "stdev s", "stdev p", "std s", "coef var", "coeff var",
      "coefficient de variation", "coefficiente di variazione", "coeficiente de variacion",
      // ends
      "min", "minimum", "max", "maximum", "range", "spannweite", "minimo", "massimo", "maximo",
      "mini", "maxi", "etendue", "intervallo", "rango", "kleinstwert", "grosstwert", "groesstwert"};
  constexpr std::size_t kLongest = 60;
  if (text.empty() || text.size() > kLongest) return SummaryRowLabel::kNone;
  if (is_summary_sign(text)) return SummaryRowLabel::kCertain;
  const std::string plain = plain_lower(text);
  if (plain.empty() || ((plain[0] < 'a' || plain[0] > 'z') && (plain[0] & 0x80) == 0)) {
    return SummaryRowLabel::kNone;
  }
  std::string label;
  // "Mean (n = 12)", "Mean:", "Std. dev.", "Écart-type"
  for (const char c : std::string_view(plain).substr(0, plain.find_first_of("([="))) {
    const bool letter = (c >= 'a' && c <= 'z') || (c & 0x80) != 0;
    if (letter) {
      label += c;
    } else if (c >= '0' && c <= '9') {
      return SummaryRowLabel::kNone;  // "Max 3" is a name
    } else if (!label.empty() && label.back() != ' ') {
      label += ' ';
    }
  }
  while (label.ends_with(' ')) label.pop_back();
  for (const std::string_view whole : {"overall ", "gesamt ", "general "}) {
    if (label.starts_with(whole) && kLabels.contains(label.substr(whole.size()))) {
      label = label.substr(whole.size());
    }
  }
  if (!kLabels.contains(label)) return SummaryRowLabel::kNone;
  const auto letters = std::count_if(label.begin(), label.end(), [](char c) { return c != ' '; });
  return letters > 2 ? SummaryRowLabel::kCertain : SummaryRowLabel::kAmbiguous;
}

bool is_possible_heading_row(const std::vector<std::string_view>& fields, char separator) {
  if (fields.empty()) return false;
  const auto ends_with_any = [](std::string_view field, std::string_view signs) {
    return !field.empty() && signs.find(field.back()) != std::string_view::npos;
  };
  const bool sentence =
      separator == ' ' && (ends_with_any(fields.back(), ".!?") ||
                           std::any_of(fields.begin(), fields.end(), [&](std::string_view field) {
                             return ends_with_any(field, ",:");
                           }));
  return !sentence && std::none_of(fields.begin(), fields.end(), [&](std::string_view field) {
    return parse_number_field(field, separator).has_value();
  });
}

}  // namespace clast
