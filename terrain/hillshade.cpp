#include "terrain/hillshade.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/nice_number.hpp"
#include "core/number_text.hpp"
#include "terrain/detail/map_canvas.hpp"
#include "terrain/gdal/map_lines.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/relief.hpp"

namespace clast {

using namespace terrain_detail;
namespace {

constexpr Rgb kInk = {17, 17, 17}, kHalo = {255, 255, 255};
constexpr double kContours = 20.0;  // about so many over the whole relief
constexpr double kMargin = 0.02;    // of the longer side

void check_near(const Vec2& mark, const Window& ground, const std::string& what) {
  const double reach = ground.size().maxCoeff();
  if ((mark.array() > ground.low.array() - reach).all() &&
      (mark.array() < ground.high.array() + reach).all()) {
    return;
  }
  throw InputError(what + " at " + place_on_map({mark.x(), mark.y(), 0.0}) +
                   " is far off the ground, which begins at " +
                   place_on_map({ground.low.x(), ground.low.y(), 0.0}) +
                   "; bring both into one map system");
}

/// The colour of the palette that is nearest: the palette has no room for many more.
std::uint8_t nearest_colour(const Picture& picture, const Rgb& rgb) {
  const auto distance = [&](const Rgb& other) {
    int sum = 0;
    for (int i = 0; i < 3; ++i) sum += (rgb[i] - other[i]) * (rgb[i] - other[i]);
    return sum;
  };
  const auto nearest =
      std::min_element(picture.palette.begin() + 1, picture.palette.end(),
                       [&](const Rgb& a, const Rgb& b) { return distance(a) < distance(b); });
  return static_cast<std::uint8_t>(nearest - picture.palette.begin());
}

std::vector<LegendRow> legend_of(const Terrain& terrain, const MapMarks& marks,
                                 const Picture& picture, double contours, std::uint8_t ink) {
  using Mark = LegendRow::Mark;
  std::vector<LegendRow> rows;
  if (!marks.releases.empty()) rows.push_back({Mark::kCross, ink, "release point"});
  if (!marks.barriers.empty()) rows.push_back({Mark::kLine, ink, "barrier"});
  if (contours > 0.0) {
    rows.push_back({Mark::kLine, nearest_colour(picture, kContourColour),
                    "contours every " + with_digits(contours, 3) + " m"});
  }
  for (std::size_t zone = 0; zone < terrain.zone_names.size(); ++zone) {
    const std::string& name = terrain.zone_names[zone];
    rows.push_back({Mark::kArea, nearest_colour(picture, zone_tint(name, zone)), name});
  }
  return rows;
}

}  // namespace

void write_hillshade(const std::filesystem::path& path, const Terrain& terrain,
                     const MapMarks& marks, const OutputRules& rules, std::uint32_t pixels) {
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.map(box.low), high = terrain.frame.map(box.high);
  const Window ground{low.head<2>(), high.head<2>()};
  Window window = ground;
  const auto include = [&](const Vec2& mark, const std::string& what) {
    check_near(mark, ground, what);
    window.low = window.low.cwiseMin(mark);
    window.high = window.high.cwiseMax(mark);
  };
  for (const Vec2& release : marks.releases) include(release, "the release point");
  for (const std::vector<Vec2>& line : marks.barriers) {
    for (const Vec2& corner : line) include(corner, "the barrier");
  }
  const double margin = kMargin * window.size().maxCoeff();
  window.low.array() -= margin;
  window.high.array() += margin;
  const double cell = window.size().maxCoeff() / pixels;
  const auto columns =
      static_cast<std::uint32_t>(std::max(1.0, std::round(window.size().x() / cell)));
  const Vec2 origin = terrain.frame.origin.head<2>();
  const Relief relief = sampled(terrain, {window.low - origin, window.high - origin}, columns);
  const double contours = round_up_to_nice((high.z() - low.z()) / kContours);
  Picture picture = relief_picture(relief, terrain.zone_names, terrain.frame.origin.z(), contours);
  MapCanvas canvas(picture, window, relief.cell);
  const std::uint8_t halo = canvas.colour(kHalo), ink = canvas.colour(kInk);
  const double stroke = std::max(1.0, pixels / 800.0);
  for (const auto& [radius, colour] : {std::pair(1.8 * stroke, halo), {stroke, ink}}) {
    for (const std::vector<Vec2>& line : marks.barriers) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        canvas.stroke(canvas.pixel(line[k]), canvas.pixel(line[k + 1]), radius, colour);
      }
    }
    for (const Vec2& place : marks.releases) {
      const Vec2 middle = canvas.pixel(place);
      for (const Vec2& arm : {Vec2(5.0, 5.0), Vec2(5.0, -5.0)}) {
        canvas.stroke(middle - stroke * arm, middle + stroke * arm, radius, colour);
      }
    }
  }
  draw_map_furniture(canvas, picture, relief.cell, stroke, ink, halo);
  draw_map_legend(canvas, picture,
                  legend_of(terrain, marks, picture, high.z() > low.z() ? contours : 0.0, ink),
                  stroke, ink, halo);
  write_output(path, palette_png(picture.width, picture.height, picture.pixels, picture.palette),
               rules);
}

std::vector<std::vector<Vec2>> read_barrier_lines(const std::filesystem::path& path,
                                                  const Terrain& terrain) {
  std::vector<std::vector<Vec2>> lines;
  for (const terrain_detail::MapLine& line :
       terrain_detail::read_map_lines(path, terrain.frame.crs)) {
    lines.emplace_back();
    for (const Vec3& point : line.points) lines.back().push_back(point.head<2>());
  }
  return lines;
}

}  // namespace clast
