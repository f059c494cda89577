#include "terrain/detail/map_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/nice_number.hpp"
#include "core/number_text.hpp"

namespace clast::terrain_detail {
namespace {

/// A character as lines through points of a grid: "x y" in digits, y down from 0 to 6, a blank
/// between two lines.
struct Glyph {
  char character;
  double advance;
  std::string_view lines;
};
constexpr Glyph kGlyphs[] = {{'0', 6, "103041453616050110"},
                             {'1', 4, "012026"},
                             {'2', 6, "011030414206 0646"},
                             {'3', 6, "01103041423313 334445361605"},
                             {'4', 6, "36300444"},
                             {'5', 6, "400003334445361605"},
                             {'6', 6, "413010010516364544331304"},
                             {'7', 6, "004016"},
                             {'8', 6, "103041423313020110 1304051636454433"},
                             {'9', 6, "051636454130100102133342"},
                             {'A', 6, "062046 1434"},
                             {'B', 6, "06003041423303 334445 3606 4536"},
                             {'C', 6, "4130100105163645"},
                             {'D', 6, "00204244260600"},
                             {'E', 6, "40000646 0333"},
                             {'F', 6, "400006 0333"},
                             {'G', 6, "41301001051636454323"},
                             {'H', 6, "0006 4046 0343"},
                             {'I', 3, "1016"},
                             {'J', 6, "4045361605"},
                             {'K', 6, "0006 400346"},
                             {'L', 6, "000646"},
                             {'M', 6, "0600234046"},
                             {'N', 6, "06004640"},
                             {'O', 6, "103041453616050110"},
                             {'P', 6, "06003041423303"},
                             {'Q', 6, "103041453616050110 2446"},
                             {'R', 6, "06003041423303 2346"},
                             {'S', 6, "413010010213334445361605"},
                             {'T', 6, "0040 2026"},
                             {'U', 6, "000516364540"},
                             {'V', 6, "002640"},
                             {'W', 6, "0016233640"},
                             {'X', 6, "0046 4006"},
                             {'Y', 6, "002340 2326"},
                             {'Z', 6, "00400646"},
                             {'k', 5, "0006 320436"},
                             {'m', 6, "0602 03122326 23324346"},
                             {'.', 3, "1616"},
                             {',', 3, "1607"},
                             {':', 3, "1212 1515"},
                             {'-', 6, "1333"},
                             {'_', 6, "0646"},
                             {'+', 6, "2125 0343"},
                             {'=', 6, "0242 0444"},
                             {'/', 6, "0640"},
                             {'>', 6, "014305"},
                             {'<', 6, "410345"},
                             {'(', 4, "20111526"},
                             {')', 4, "00111506"},
                             {'?', 6, "01103041422324 2626"}};
constexpr double kBlank = 3.0;

const Glyph* glyph_of(char character) {
  const auto* found = std::find_if(std::begin(kGlyphs), std::end(kGlyphs), [&](const Glyph& glyph) {
    return glyph.character == character;
  });
  return found == std::end(kGlyphs) ? nullptr : found;
}

/// The text in the capitals and signs that there are: accents are dropped, what is not known
/// becomes a question mark.
std::string in_capitals(const std::string& text) {
  // Letters U+00C0 to U+00FF without their accents.
  constexpr std::string_view kLatin =
      "AAAAAAACEEEEIIII?NOOOOO?OUUUUY?SAAAAAAACEEEEIIII?NOOOOO?OUUUUY?Y";
  std::string capitals;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    char letter = text[i];
    if (byte == 0xC3 && i + 1 < text.size()) {
      letter = kLatin[static_cast<unsigned char>(text[++i]) & 0x3Fu];
    } else if (byte >= 0x80) {
      if ((byte & 0xC0u) == 0x80u) continue;  // goes on with the character before
      letter = '?';
    } else if (byte >= 'a' && byte <= 'z') {
      letter = static_cast<char>(byte - 'a' + 'A');
    }
    capitals += letter == ' ' || glyph_of(letter) ? letter : '?';
  }
  return capitals;
}

double width_of(const std::string& text) {
  double width = 0.0;
  for (const char character : text) {
    const Glyph* glyph = glyph_of(character);
    width += glyph ? glyph->advance : kBlank;
  }
  return width;
}

}  // namespace

std::uint8_t MapCanvas::colour(const Rgb& rgb) {
  picture_.palette.push_back(rgb);
  return static_cast<std::uint8_t>(picture_.palette.size() - 1);
}

Vec2 MapCanvas::pixel(const Vec2& place) const {
  return {(place.x() - window_.low.x()) / cell_ - 0.5,
          (window_.high.y() - place.y()) / cell_ - 0.5};
}

void MapCanvas::stroke(const Vec2& a, const Vec2& b, double radius, std::uint8_t colour) {
  const auto clamped = [](double value, std::uint32_t count) {
    return static_cast<long>(std::clamp(value, -1.0, static_cast<double>(count)));
  };
  const long first = clamped(std::min(a.x(), b.x()) - radius, picture_.width);
  const long last = clamped(std::max(a.x(), b.x()) + radius, picture_.width);
  const long top = clamped(std::min(a.y(), b.y()) - radius, picture_.height);
  const long bottom = clamped(std::max(a.y(), b.y()) + radius, picture_.height);
  const double length = (b - a).squaredNorm();
  for (long row = std::max(top, 0L); row <= bottom && row < picture_.height; ++row) {
    for (long column = std::max(first, 0L); column <= last && column < picture_.width; ++column) {
      const Vec2 at(static_cast<double>(column), static_cast<double>(row));
      const double share = length > 0.0 ? std::clamp((at - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
      if ((a + share * (b - a) - at).norm() > radius) continue;
      picture_.pixels[static_cast<std::size_t>(row) * picture_.width +
                      static_cast<std::size_t>(column)] = colour;
    }
  }
}

void MapCanvas::fill(const Vec2& low, const Vec2& high, std::uint8_t colour) {
  const auto within = [](double value, std::uint32_t count) {
    return static_cast<std::size_t>(std::clamp(std::round(value), 0.0, static_cast<double>(count)));
  };
  const std::size_t left = within(low.x(), picture_.width);
  const std::size_t right = within(high.x(), picture_.width);
  for (std::size_t row = within(low.y(), picture_.height); row < within(high.y(), picture_.height);
       ++row) {
    for (std::size_t column = left; column < right; ++column) {
      picture_.pixels[row * picture_.width + column] = colour;
    }
  }
}

void MapCanvas::text(const Vec2& at, const std::string& text, double unit, std::uint8_t colour) {
  double left = at.x();
  for (const char character : text) {
    const Glyph* glyph = glyph_of(character);
    if (!glyph) {
      left += kBlank * unit;
      continue;
    }
    const auto point = [&](std::size_t i) -> Vec2 {
      return {left + unit * (glyph->lines[i] - '0'), at.y() + unit * (glyph->lines[i + 1] - '0')};
    };
    for (std::size_t i = 0; i + 3 < glyph->lines.size(); i += 2) {
      if (glyph->lines[i + 2] == ' ') {
        i += 1;  // the next line begins behind the blank
        continue;
      }
      stroke(point(i), point(i + 2), 0.55 * unit, colour);
    }
    left += glyph->advance * unit;
  }
}

void draw_map_furniture(MapCanvas& canvas, const Picture& picture, double cell, double unit,
                        std::uint8_t ink, std::uint8_t paper) {
  constexpr double kLongest = 0.2;  // of the picture's width
  const double margin = 6.0 * unit, letter = 1.6 * unit, thick = 5.0 * unit;
  const double width = picture.width, height = picture.height;

  const double metres = round_down_to_nice(kLongest * width * cell);
  const double length = metres / cell;
  const std::string label =
      metres >= 1000.0 ? with_digits(metres / 1000.0, 3) + " km" : with_digits(metres, 3) + " m";
  const Vec2 bar(2.0 * margin, height - 2.0 * margin - thick);
  canvas.fill({margin, bar.y() - 6.0 * letter - 2.0 * margin},
              {bar.x() + std::max(length, letter * width_of(label)) + margin, height - margin},
              paper);
  canvas.fill(bar, bar + Vec2(length, thick), ink);
  canvas.fill(bar + Vec2(0.5 * length + unit, unit), bar + Vec2(length - unit, thick - unit),
              paper);
  canvas.text({bar.x() + std::max(0.0, 0.5 * (length - letter * width_of(label))),
               bar.y() - 6.0 * letter - margin},
              label, letter, ink);

  const Vec2 tip(width - 4.5 * margin, 2.0 * margin);
  canvas.stroke(tip + Vec2(0.0, 13.0 * unit), tip + Vec2(0.0, 13.0 * unit), 20.0 * unit, paper);
  for (double y = 0.0; y <= 14.0 * unit; y += 0.5) {  // a triangle, row by row
    canvas.stroke(tip + Vec2(-0.5 * y, y), tip + Vec2(0.5 * y, y), 0.5, ink);
  }
  canvas.text(tip + Vec2(-2.0 * letter, 18.0 * unit), "N", letter, ink);
}

void draw_map_legend(MapCanvas& canvas, const Picture& picture, std::span<const LegendRow> rows,
                     double unit, std::uint8_t ink, std::uint8_t paper) {
  constexpr double kLargest = 0.45;  // of the picture's width and height
  constexpr std::size_t kMostCharacters = 28;
  const double margin = 6.0 * unit, letter = 1.3 * unit, line = 10.0 * letter, mark = 14.0 * unit;
  const auto fitting =
      static_cast<std::size_t>(std::max(0.0, kLargest * picture.height / line - 1.0));
  std::vector<std::string> texts;
  for (const LegendRow& row : rows) {
    texts.push_back(in_capitals(row.text));
    if (texts.back().size() > kMostCharacters)
      texts.back().replace(kMostCharacters - 2, std::string::npos, "..");
  }
  std::size_t shown = rows.size();
  if (shown > fitting) {
    if (fitting < 2) return;  // a picture too small for it
    shown = fitting - 1;
    texts[shown] = "+ " + std::to_string(rows.size() - shown);
  }
  double width = 0.0;
  for (std::size_t i = 0; i < std::min(rows.size(), shown + 1); ++i) {
    width = std::max(width, letter * width_of(texts[i]));
  }
  width += mark + 3.0 * margin;
  if (width > kLargest * picture.width) return;
  const std::size_t lines = std::min(rows.size(), shown + (shown < rows.size() ? 1 : 0));
  const Vec2 end(picture.width - margin, picture.height - margin);
  const Vec2 begin = end - Vec2(width, line * static_cast<double>(lines) + margin);
  canvas.fill(begin, end, paper);
  for (std::size_t i = 0; i < lines; ++i) {
    const Vec2 at = begin + Vec2(margin, margin + line * static_cast<double>(i));
    const Vec2 middle = at + Vec2(0.5 * mark, 3.0 * letter);
    if (i < shown) {
      switch (rows[i].mark) {
        case LegendRow::Mark::kArea:
          canvas.fill(at, at + Vec2(mark, 6.0 * letter), rows[i].colour);
          break;
        case LegendRow::Mark::kCross:
          for (const Vec2& arm : {Vec2(4.0, 4.0), Vec2(4.0, -4.0)}) {
            canvas.stroke(middle - unit * arm, middle + unit * arm, unit, rows[i].colour);
          }
          break;
        case LegendRow::Mark::kLine:
          canvas.stroke(middle - Vec2(0.5 * mark, 0.0), middle + Vec2(0.5 * mark, 0.0), unit,
                        rows[i].colour);
          break;
      }
    }
    canvas.text(at + Vec2(mark + margin, 0.0), texts[i], letter, ink);
  }
}

}  // namespace clast::terrain_detail
