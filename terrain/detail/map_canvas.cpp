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
constexpr Glyph kGlyphs[] = {
    {'0', 6, "103041453616050110"},     {'1', 4, "012026"},  {'2', 6, "011030414206 0646"},
    {'5', 6, "400003334445361605"},     {'.', 3, "1616"},    {'k', 5, "0006 320436"},
    {'m', 6, "0602 03122326 23324346"}, {'N', 6, "06004640"}};
constexpr double kBlank = 3.0;

const Glyph* glyph_of(char character) {
  const auto* found = std::find_if(std::begin(kGlyphs), std::end(kGlyphs), [&](const Glyph& glyph) {
    return glyph.character == character;
  });
  return found == std::end(kGlyphs) ? nullptr : found;
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

}  // namespace clast::terrain_detail
