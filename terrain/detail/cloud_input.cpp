#include "terrain/detail/cloud_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

namespace clast::detail {
namespace {

constexpr double kMostCells = 2e9;

}  // namespace

HeightGrid binned(std::span<const Vec3> points, double cell, const std::filesystem::path& path) {
  Vec2 low = points[0].head<2>(), high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point.head<2>());
    high = high.cwiseMax(point.head<2>());
  }
  const Vec2 first_cell = (low / cell).array().floor();
  const Vec2 count = (high / cell).array().floor() - first_cell.array() + 1.0;
  if (!(count.prod() < kMostCells)) {
    throw InputError(path.string() + ": cells of " + std::to_string(cell) + " m over " +
                     std::to_string((high - low).x()) + " x " + std::to_string((high - low).y()) +
                     " m are too many; use a larger --resolution");
  }
  HeightGrid grid;
  grid.columns = static_cast<std::size_t>(count.x());
  grid.rows = static_cast<std::size_t>(count.y());
  grid.step = {cell, cell};
  grid.first = (first_cell + Vec2(0.5, 0.5)) * cell;
  grid.heights.assign(grid.columns * grid.rows, 0.0);
  std::vector<std::uint32_t> hits(grid.heights.size(), 0);
  for (const Vec3& point : points) {
    const Vec2 at = (point.head<2>() / cell).array().floor() - first_cell.array();
    const std::size_t index =
        static_cast<std::size_t>(at.y()) * grid.columns + static_cast<std::size_t>(at.x());
    grid.heights[index] += point.z();
    ++hits[index];
  }
  for (std::size_t i = 0; i < hits.size(); ++i) {
    grid.heights[i] =
        hits[i] > 0 ? grid.heights[i] / hits[i] : std::numeric_limits<double>::quiet_NaN();
  }
  return grid;
}

std::size_t fill_pinholes(HeightGrid& grid) {
  constexpr std::array<std::pair<long, long>, 4> kHalf = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  constexpr int kRounds = 2;
  constexpr int kLeastKnown = 5;  // so that at least one pair of opposite neighbours is known
  const long columns = static_cast<long>(grid.columns), rows = static_cast<long>(grid.rows);
  const auto height = [&](long i, long j) {
    const bool inside = i >= 0 && j >= 0 && i < columns && j < rows;
    return inside ? grid.heights[static_cast<std::size_t>(j * columns + i)]
                  : std::numeric_limits<double>::quiet_NaN();
  };
  std::size_t total = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::pair<std::size_t, double>> filled;
    for (std::size_t cell = 0; cell < grid.heights.size(); ++cell) {
      if (std::isfinite(grid.heights[cell])) continue;
      const long i = static_cast<long>(cell) % columns, j = static_cast<long>(cell) / columns;
      int known = 0, pairs = 0;
      double sum = 0.0;
      for (const auto& [di, dj] : kHalf) {
        const double one = height(i + di, j + dj), other = height(i - di, j - dj);
        known += std::isfinite(one) + std::isfinite(other);
        if (!std::isfinite(one) || !std::isfinite(other)) continue;
        sum += (one + other) / 2.0;
        ++pairs;
      }
      if (known >= kLeastKnown) filled.emplace_back(cell, sum / pairs);
    }
    for (const auto& [cell, value] : filled) grid.heights[cell] = value;
    total += filled.size();
  }
  return total;
}

double default_cell(std::span<const Vec3> points) {
  Bounds box;
  for (const Vec3& point : points) box.include(point);
  const double area = (box.high - box.low).head<2>().prod();
  const double wanted = 2.0 * std::sqrt(area / static_cast<double>(points.size()));
  if (!(wanted > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= wanted * (1.0 - 1e-9)) return digit * decade;
  }
  return 10.0 * decade;
}

}  // namespace clast::detail
