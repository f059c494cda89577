#include "terrain/hillshade.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/nice_number.hpp"
#include "core/number_text.hpp"
#include "terrain/detail/map_lines.hpp"
#include "terrain/detail/raw_surface.hpp"
#include "terrain/relief.hpp"

namespace clast {
namespace {

constexpr Rgb kRelease = {200, 20, 20}, kHalo = {255, 255, 255}, kBarrier = {20, 20, 20};
constexpr double kContours = 20.0;  // about so many over the whole relief
constexpr double kMargin = 0.02;    // of the longer side

/// Draws on a picture of a window of the plan.
class Canvas {
 public:
  Canvas(Picture& picture, const Window& window, double cell)
      : picture_(picture), window_(window), cell_(cell) {}

  std::uint8_t colour(const Rgb& rgb) {
    picture_.palette.push_back(rgb);
    return static_cast<std::uint8_t>(picture_.palette.size() - 1);
  }

  /// All pixels whose centre is within `radius` pixels of the segment.
  void stroke(const Vec2& from, const Vec2& to, double radius, std::uint8_t colour) {
    const Vec2 a = pixel(from), b = pixel(to);
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
        const double share =
            length > 0.0 ? std::clamp((at - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
        if ((a + share * (b - a) - at).norm() > radius) continue;
        picture_.pixels[static_cast<std::size_t>(row) * picture_.width +
                        static_cast<std::size_t>(column)] = colour;
      }
    }
  }

 private:
  /// In pixels from the centre of the first.
  Vec2 pixel(const Vec2& place) const {
    return {(place.x() - window_.low.x()) / cell_ - 0.5,
            (window_.high.y() - place.y()) / cell_ - 0.5};
  }

  Picture& picture_;
  Window window_;
  double cell_;
};

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
  Picture picture = relief_picture(relief, terrain.zone_names, terrain.frame.origin.z(),
                                   round_up_to_nice((high.z() - low.z()) / kContours));
  Canvas canvas(picture, window, relief.cell);
  const std::uint8_t halo = canvas.colour(kHalo), barrier = canvas.colour(kBarrier);
  const std::uint8_t release = canvas.colour(kRelease);
  const double stroke = std::max(1.0, pixels / 800.0);
  for (const auto& [radius, colour] : {std::pair(1.8 * stroke, halo), {stroke, barrier}}) {
    for (const std::vector<Vec2>& line : marks.barriers) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        canvas.stroke(line[k], line[k + 1], radius, colour);
      }
    }
  }
  for (const Vec2& place : marks.releases) {
    canvas.stroke(place, place, 4.0 * stroke, halo);
    canvas.stroke(place, place, 3.0 * stroke, release);
  }
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
