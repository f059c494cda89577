#include "study/proposal/detail/fall_paths.hpp"

#include <algorithm>
#include <cmath>

#include "terrain/relief.hpp"

namespace clast::study_detail {
namespace {

constexpr double kLeastCells = 12.0;       ///< across the narrower side
constexpr double kMostPathCells = 2000.0;  ///< along the longer one
constexpr double kStartHead = 1.0;         ///< m of fall that the point has at its start
constexpr double kLargestHead = 20.0;      ///< m: blocks on slopes are seldom faster than 20 m/s

}  // namespace

GroundGrid::GroundGrid(const Terrain& terrain, double cell) {
  const Bounds box = bounds(terrain.surface);
  const Window window{box.low.head<2>(), box.high.head<2>()};
  cell = std::max(std::min(cell, window.size().minCoeff() / kLeastCells),
                  window.size().maxCoeff() / kMostPathCells);
  const Relief relief =
      sampled(terrain, window, static_cast<std::uint32_t>(std::ceil(window.size().x() / cell)));
  cell_ = relief.cell;
  columns_ = relief.columns;
  rows_ = relief.rows;
  low_ = {window.low.x(), window.high.y() - relief.cell * relief.rows};
  height_.resize(relief.height.size());
  covered_.assign(std::size_t{columns_ + 1} * (rows_ + 1), 0);
  for (std::uint32_t row = 0; row < rows_; ++row) {
    for (std::uint32_t column = 0; column < columns_; ++column) {
      const double z = relief.height[std::size_t{rows_ - 1 - row} * columns_ + column];
      height_[index(column, row)] = z;
      const std::size_t below = std::size_t{row} * (columns_ + 1) + column;
      const std::size_t above = below + columns_ + 1;
      covered_[above + 1] =
          covered_[above] + covered_[below + 1] - covered_[below] + (std::isnan(z) ? 0 : 1);
    }
  }
}

std::size_t GroundGrid::index(std::int64_t column, std::int64_t row) const {
  return static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
}

std::int64_t GroundGrid::column_of(double x) const {
  return static_cast<std::int64_t>(std::floor((x - low_.x()) / cell_));
}

std::int64_t GroundGrid::row_of(double y) const {
  return static_cast<std::int64_t>(std::floor((y - low_.y()) / cell_));
}

Vec2 GroundGrid::centre(std::uint32_t column, std::uint32_t row) const {
  return low_ + cell_ * Vec2(column + 0.5, row + 0.5);
}

std::optional<GroundSlope> GroundGrid::slope(const Vec2& place) const {
  const std::int64_t column = column_of(place.x()), row = row_of(place.y());
  if (column < 1 || row < 1 || column + 1 >= columns_ || row + 1 >= rows_) return std::nullopt;
  double sum = 0.0;
  Vec2 rise = Vec2::Zero();
  for (std::int64_t i = -1; i <= 1; ++i) {
    for (std::int64_t j = -1; j <= 1; ++j) {
      const double z = height_[index(column + i, row + j)];
      sum += z;
      rise += z * Vec2(static_cast<double>(i), static_cast<double>(j));
    }
  }
  if (std::isnan(sum)) return std::nullopt;
  const Vec2 gradient = rise / (6.0 * cell_);
  const Vec2 middle = centre(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
  return GroundSlope{sum / 9.0 + gradient.dot(place - middle), gradient};
}

bool GroundGrid::covered(const Vec2& place, double half_width) const {
  const Vec2 half(half_width, half_width);
  const Vec2 low = place - half, high = place + half;
  const std::int64_t left = column_of(low.x()), right = column_of(high.x());
  const std::int64_t bottom = row_of(low.y()), top = row_of(high.y());
  if (left < 0 || bottom < 0 || right >= columns_ || top >= rows_) return false;
  const auto sum = [&](std::int64_t column, std::int64_t row) {
    return std::int64_t{covered_[static_cast<std::size_t>(row) * (columns_ + 1) +
                                 static_cast<std::size_t>(column)]};
  };
  const std::int64_t cells = (right - left + 1) * (top - bottom + 1);
  return sum(right + 1, top + 1) - sum(left, top + 1) - sum(right + 1, bottom) +
             sum(left, bottom) ==
         cells;
}

std::vector<Vec3> fall_path(const GroundGrid& grid, const Vec2& start, double friction) {
  std::vector<Vec3> path;
  Vec2 place = start, direction = Vec2::Zero();
  double head = kStartHead;
  const std::size_t longest = 4 * (std::size_t{grid.columns()} + grid.rows());
  while (path.size() < longest) {
    const std::optional<GroundSlope> ground = grid.slope(place);
    if (!ground) break;
    if (path.empty()) {
      if (!(ground->gradient.norm() > 0.0)) break;
      direction = -ground->gradient.normalized();
    } else {
      head += path.back().z() - ground->height - friction * grid.cell();
      if (!(head > 0.0)) break;
      head = std::min(head, kLargestHead);
    }
    path.emplace_back(place.x(), place.y(), ground->height);
    // Of the gradient, what is across the way bends it, by 1 / (2 head) per metre.
    const Vec2 across = ground->gradient - ground->gradient.dot(direction) * direction;
    direction -= across * (grid.cell() / (2.0 * std::max(head, grid.cell())));
    direction.normalize();
    place += grid.cell() * direction;
  }
  return path;
}

}  // namespace clast::study_detail
