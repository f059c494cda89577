#pragma once
/// Strokes, north arrow and scale bar on a picture of the plan.
#include <cstdint>
#include <span>
#include <string>

#include "terrain/relief.hpp"

namespace clast::terrain_detail {

/// Draws on a picture in pixels, right and down from the centre of its first.
class MapCanvas {
 public:
  /// @param cell  side of a pixel, m
  MapCanvas(Picture& picture, const Window& window, double cell)
      : picture_(picture), window_(window), cell_(cell) {}

  /// Adds a colour to the palette.
  std::uint8_t colour(const Rgb& rgb);
  Vec2 pixel(const Vec2& place_on_map) const;
  /// All pixels whose centre is within `radius` pixels of the segment.
  void stroke(const Vec2& from, const Vec2& to, double radius, std::uint8_t colour);
  /// All pixels of a rectangle between two corners.
  void fill(const Vec2& low, const Vec2& high, std::uint8_t colour);
  /// Digits, capitals, the letters k and m of a scale bar, and some signs; other characters are
  /// blanks.
  /// @param at    top left corner
  /// @param unit  a sixth of the height of a capital letter, px
  void text(const Vec2& at, const std::string& text, double unit, std::uint8_t colour);

 private:
  Picture& picture_;
  Window window_;
  double cell_;
};

/// Scale bar at the lower left and arrow to the north at the upper right, on pale panels.
/// @param unit  width of a thin line, px
void draw_map_furniture(MapCanvas& canvas, const Picture& picture, double cell, double unit,
                        std::uint8_t ink, std::uint8_t paper);

/// A line of the legend.
struct LegendRow {
  enum class Mark { kArea, kCross, kLine };
  Mark mark = Mark::kArea;
  std::uint8_t colour = 0;  ///< in the palette
  std::string text;         ///< drawn in capitals
};

/// Legend on a pale panel at the lower right. Rows that do not fit into half of the picture are
/// counted in the last one; a picture too small for any has none.
/// @param unit  width of a thin line, px
void draw_map_legend(MapCanvas& canvas, const Picture& picture, std::span<const LegendRow> rows,
                     double unit, std::uint8_t ink, std::uint8_t paper);

}  // namespace clast::terrain_detail
