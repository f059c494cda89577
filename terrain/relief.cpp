#include "terrain/relief.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/plan_geometry.hpp"

namespace clast {
namespace {

constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
constexpr int kShades = 30;        // grey levels per tint
constexpr double kDarkest = 0.62;  // of the tint, in full shade; marks must stay readable on it

/// Pale colours by the word they are called, then a set for other names.
constexpr std::array<std::pair<const char*, Rgb>, 7> kTints = {{{"blue", {198, 219, 239}},
                                                                {"gray", {217, 217, 217}},
                                                                {"grey", {217, 217, 217}},
                                                                {"red", {245, 204, 198}},
                                                                {"green", {208, 228, 200}},
                                                                {"yellow", {245, 236, 190}},
                                                                {"brown", {224, 208, 186}}}};
constexpr std::array<Rgb, 6> kOtherTints = {{{233, 223, 201},
                                             {214, 220, 224},
                                             {211, 226, 204},
                                             {240, 211, 205},
                                             {207, 222, 238},
                                             {224, 213, 233}}};

void sample_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::uint16_t zone,
                     const PlanWindow& window, Relief& relief) {
  const Vec2 plan_a = a.head<2>(), plan_b = b.head<2>(), plan_c = c.head<2>();
  const double area = twice_area(plan_a, plan_b, plan_c);
  // Facing down, it may still be uppermost: where the survey ends on an overhang.
  if (area < 0.0) return sample_triangle(a, c, b, zone, window, relief);
  if (!(area > 0.0)) return;  // upright: its neighbours have the heights
  const auto cell_range = [&](double low, double high, std::uint32_t count) {
    const double last = static_cast<double>(count) - 1.0;
    const double from = std::clamp(std::ceil(low / relief.cell - 0.5), 0.0, last + 1.0);
    const double to = std::clamp(std::floor(high / relief.cell - 0.5), -1.0, last);
    return std::pair<long, long>(std::lround(from), std::lround(to));
  };
  const auto [x_low, x_high] = std::minmax({a.x(), b.x(), c.x()});
  const auto [y_low, y_high] = std::minmax({a.y(), b.y(), c.y()});
  const auto [first_column, last_column] =
      cell_range(x_low - window.low.x(), x_high - window.low.x(), relief.columns);
  const auto [first_row, last_row] =
      cell_range(window.high.y() - y_high, window.high.y() - y_low, relief.rows);
  for (long row = first_row; row <= last_row; ++row) {
    const double y = window.high.y() - (static_cast<double>(row) + 0.5) * relief.cell;
    for (long column = first_column; column <= last_column; ++column) {
      const double x = window.low.x() + (static_cast<double>(column) + 0.5) * relief.cell;
      const Vec2 at(x, y);
      const double u = twice_area(plan_b, plan_c, at), v = twice_area(plan_c, plan_a, at),
                   w = twice_area(plan_a, plan_b, at);
      // Centres on an edge belong to both sides, whatever the rounding.
      if (std::min({u, v, w}) < -1e-12 * area) continue;
      const double z = (u * a.z() + v * b.z() + w * c.z()) / area;
      const std::size_t cell =
          static_cast<std::size_t>(row) * relief.columns + static_cast<std::size_t>(column);
      if (relief.height[cell] >= z) continue;  // an overhang above hides this
      relief.height[cell] = z;
      relief.zone[cell] = zone;
    }
  }
}

/// Brightness in [0, 1] of every cell; -1 where there is no ground.
std::vector<double> shades(const Relief& relief) {
  const Vec3 light = Vec3(-1.0, 1.0, std::sqrt(2.0)).normalized();
  const auto at = [&](long row, long column, double otherwise) {
    row = std::clamp(row, 0L, static_cast<long>(relief.rows) - 1);
    column = std::clamp(column, 0L, static_cast<long>(relief.columns) - 1);
    const double z = relief.height[static_cast<std::size_t>(row) * relief.columns +
                                   static_cast<std::size_t>(column)];
    return std::isnan(z) ? otherwise : z;
  };
  std::vector<double> shade(relief.height.size(), -1.0);
  for (long row = 0; row < static_cast<long>(relief.rows); ++row) {
    for (long column = 0; column < static_cast<long>(relief.columns); ++column) {
      const double z = at(row, column, kNoHeight);
      if (std::isnan(z)) continue;
      double dx = 0.0, dy = 0.0;
      for (const int step : {-1, 0, 1}) {
        const double weight = step == 0 ? 2.0 : 1.0;
        dx += weight * (at(row + step, column + 1, z) - at(row + step, column - 1, z));
        dy += weight * (at(row - 1, column + step, z) - at(row + 1, column + step, z));
      }
      const Vec3 normal = Vec3(-dx / (8.0 * relief.cell), -dy / (8.0 * relief.cell), 1.0);
      shade[static_cast<std::size_t>(row) * relief.columns + static_cast<std::size_t>(column)] =
          std::max(0.0, normal.normalized().dot(light));
    }
  }
  return shade;
}

/// Neighbouring cells are level if their heights differ by no more than this, m: the rounding of
/// heights on level ground draws no contours.
constexpr double kLevel = 1e-6;

/// True where a contour passes between this cell and the one to its right or below.
bool on_contour(const Relief& relief, std::uint32_t row, std::uint32_t column, double first_height,
                double interval) {
  const auto height = [&](std::uint32_t r, std::uint32_t c) {
    return relief.height[std::size_t{r} * relief.columns + c];
  };
  const auto band = [&](double z) { return std::floor((z + first_height) / interval); };
  const double here = height(row, column);
  const auto differs = [&](double there) {
    return std::abs(there - here) > kLevel && band(there) != band(here);
  };
  return (column + 1 < relief.columns && differs(height(row, column + 1))) ||
         (row + 1 < relief.rows && differs(height(row + 1, column)));
}

std::uint8_t part_of(double share, std::uint8_t colour) {
  return static_cast<std::uint8_t>(std::lround(share * colour));
}

}  // namespace

Relief sample_relief(const Terrain& terrain, const PlanWindow& window, std::uint32_t columns) {
  Relief relief;
  relief.columns = columns;
  relief.cell = window.size().x() / columns;
  relief.rows =
      static_cast<std::uint32_t>(std::max(1.0, std::round(window.size().y() / relief.cell)));
  relief.height.assign(std::size_t{relief.columns} * relief.rows, kNoHeight);
  relief.zone.assign(relief.height.size(), 0);
  const TriangleMesh& mesh = terrain.surface;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const TriangleMesh::Triangle& triangle = mesh.triangles[i];
    sample_triangle(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]],
                    mesh.vertices[triangle[2]], i < terrain.zone.size() ? terrain.zone[i] : 0,
                    window, relief);
  }
  return relief;
}

Rgb zone_colour(const std::string& name, std::size_t n) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const auto& [word, tint] : kTints) {
    if (lower == word) return tint;
  }
  return kOtherTints[n % kOtherTints.size()];
}

std::string render_relief_png(const Relief& relief, const std::vector<std::string>& zone_names,
                              double first_height, double contour_interval) {
  // Zones of one tint share palette entries, so that any number of zones fits into 256.
  std::vector<Rgb> palette = {{255, 255, 255}, kContourColour};
  std::vector<Rgb> tints;
  std::vector<std::size_t> tint_of_zone;
  constexpr std::size_t kFixedColours = 2;
  constexpr std::size_t kMaxTints = (250 - kFixedColours) / (kShades + 1);
  for (std::size_t zone = 0; zone < std::max<std::size_t>(zone_names.size(), 1); ++zone) {
    const Rgb tint = zone_colour(zone < zone_names.size() ? zone_names[zone] : "", zone);
    std::size_t n =
        static_cast<std::size_t>(std::find(tints.begin(), tints.end(), tint) - tints.begin());
    if (n == tints.size() && n < kMaxTints) tints.push_back(tint);
    tint_of_zone.push_back(std::min(n, tints.size() - 1));
  }
  for (const Rgb& tint : tints) {
    for (int level = 0; level <= kShades; ++level) {
      const double share = kDarkest + (1.0 - kDarkest) * level / kShades;
      palette.push_back(
          {part_of(share, tint[0]), part_of(share, tint[1]), part_of(share, tint[2])});
    }
  }

  const std::vector<double> shade = shades(relief);
  std::vector<std::uint8_t> pixels(shade.size(), 0);
  for (std::uint32_t row = 0; row < relief.rows; ++row) {
    for (std::uint32_t column = 0; column < relief.columns; ++column) {
      const std::size_t cell = std::size_t{row} * relief.columns + column;
      if (shade[cell] < 0.0) continue;
      if (on_contour(relief, row, column, first_height, contour_interval)) {
        pixels[cell] = 1;
        continue;
      }
      // Flat ground has shade 0.71; all that faces the light more than 0.85 gets the plain tint.
      const double level = std::min(1.0, shade[cell] / 0.85);
      const std::size_t zone = std::min<std::size_t>(relief.zone[cell], tint_of_zone.size() - 1);
      pixels[cell] =
          static_cast<std::uint8_t>(kFixedColours + tint_of_zone[zone] * (kShades + 1) +
                                    static_cast<std::size_t>(std::lround(level * kShades)));
    }
  }
  return encode_palette_png(relief.columns, relief.rows, pixels, palette);
}

}  // namespace clast
