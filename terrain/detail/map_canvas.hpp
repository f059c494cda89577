#pragma once
/// Strokes, north arrow and scale bar on a picture of the plan.
#include <cstdint>
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
  /// Digits 0, 1, 2 and 5, the point, and the letters k, m and N, which is what a scale bar and a
  /// north arrow need; other characters are blanks.
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

}  // namespace clast::terrain_detail
