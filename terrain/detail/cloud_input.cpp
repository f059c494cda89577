#include "terrain/detail/cloud_input.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

namespace clast::detail {
namespace {

constexpr std::string_view kSeparators = " \t\r,;";
constexpr double kMostCells = 2e9;

/// Takes the next word off `line`; empty at its end.
std::string_view next_word(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(kSeparators);
  if (begin == std::string_view::npos) return line = {};
  line.remove_prefix(begin);
  const std::string_view word = line.substr(0, line.find_first_of(kSeparators));
  line.remove_prefix(word.size());
  return word;
}

/// Columns of x, y and z in a heading; the first three when it does not name them.
std::array<std::size_t, 3> columns_in(std::string_view heading) {
  std::array<std::size_t, 3> columns = {0, 1, 2};
  std::array<bool, 3> found{};
  for (std::size_t i = 0;; ++i) {
    const std::string_view word = next_word(heading);
    if (word.empty()) break;
    std::string name;
    for (const char c : word) {
      if (c != '"') name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (found[axis] || name != std::string(1, "xyz"[axis])) continue;
      columns[axis] = i;
      found[axis] = true;
    }
  }
  return found[0] && found[1] && found[2] ? columns : std::array<std::size_t, 3>{0, 1, 2};
}

}  // namespace

bool is_cloud(const std::filesystem::path& path) {
  static const std::set<std::string> kKnown = {".xyz", ".txt", ".csv", ".pts"};
  return kKnown.contains(extension_of(path));
}

std::vector<Vec3> read_cloud(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  std::vector<Vec3> points;
  std::array<std::size_t, 3> columns = {0, 1, 2};
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // byte order mark
  bool first = true;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    std::string_view words = line;
    const std::string_view start = next_word(words);
    if (start.empty() || start.starts_with('#') || start.starts_with("//")) continue;
    const bool heading = first && !number_in(start);
    const bool count_only = first && !heading && next_word(words).empty();
    first = false;
    if (heading) columns = columns_in(line);
    if (heading || count_only) continue;

    Vec3 point = Vec3::Zero();
    std::size_t left = 3;
    words = line;
    for (std::size_t column = 0; left > 0; ++column) {
      const std::string_view word = next_word(words);
      if (word.empty()) break;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (columns[axis] != column) continue;
        const std::optional<double> value = number_in(word);
        if (!value || !std::isfinite(*value)) {
          throw InputError(path.string() + ":" + std::to_string(number) + ": \"" +
                           std::string(word.substr(0, 40)) + "\" stands where " + "xyz"[axis] +
                           " is needed; a line must be x y z in metres");
        }
        point[static_cast<Eigen::Index>(axis)] = *value;
        --left;
      }
    }
    if (left > 0) {
      throw InputError(path.string() + ":" + std::to_string(number) +
                       ": fewer than three numbers; a line must be x y z in metres");
    }
    points.push_back(point);
  }
  if (points.empty()) throw InputError(path.string() + ": holds no points; each line is x y z");
  return points;
}

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
