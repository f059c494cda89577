#include "dem/search/detail/ballistic_sphere.hpp"

#include <algorithm>
#include <cmath>

namespace clast::dem_detail {
namespace {

/// Displacement of the ball in one interval, as a fraction of the larger of cell size and radius.
constexpr double kPieceFraction = 0.5;

/// True if no ground touches the ball within `spread` of `middle` in plan, at or above `lowest`.
bool clear_of(const PlanGrid& grid, const Vec2& middle, double spread, double lowest,
              double radius) {
  const double reach = radius + spread;
  const PlanGrid::CellRange window = grid.cell_range(middle.x() - reach, middle.x() + reach,
                                                     middle.y() - reach, middle.y() + reach);
  for (int row = window.first_row; row <= window.last_row; ++row) {
    for (int column = window.first_column; column <= window.last_column; ++column) {
      const double high = grid.max_cell_height(column, row);
      if (high < lowest - radius) continue;
      // Smallest horizontal distance of the cell from the ball's centre in this interval.
      const double beside = std::max(0.0, grid.distance_to_cell(column, row, middle) - spread);
      const double below = radius * radius - beside * beside;
      if (below >= 0.0 && high >= lowest - std::sqrt(below)) return false;
    }
  }
  return true;
}

/// True if the grid cell at a position contains ground.
bool surveyed(const PlanGrid& grid, const Vec2& position) {
  const PlanGrid::CellRange home =
      grid.cell_range(position.x(), position.x(), position.y(), position.y());
  return home.first_column <= home.last_column && home.first_row <= home.last_row &&
         !grid.cell(home.first_column, home.first_row).faces.empty();
}

}  // namespace

double ballistic_contact_free_time(const PlanGrid& grid, const BallisticSphere& ball,
                                   double longest) {
  const Vec2 along = ball.velocity.head<2>();
  const double piece = kPieceFraction * std::max(grid.cell_size(), ball.radius);
  const auto height = [&](double time) {
    return ball.centre.z() + time * (ball.velocity.z() - 0.5 * ball.gravity * time);
  };
  double clear = 0.0;
  while (clear < longest) {
    // Upper bound of the speed during the next interval.
    const double fall = std::abs(ball.velocity.z() - ball.gravity * clear);
    const double speed = std::max(along.norm(), fall);
    const double duration =
        std::min(2.0 * piece / (speed + std::sqrt(speed * speed + 2.0 * ball.gravity * piece)),
                 longest - clear);
    const double end = clear + duration;
    // A parabola that opens downwards is lowest at one of its ends.
    const double lowest = std::min(height(clear), height(end));
    const Vec2 middle = ball.centre.head<2>() + 0.5 * (clear + end) * along;
    if (!clear_of(grid, middle, 0.5 * duration * along.norm(), lowest, ball.radius)) break;
    if (!surveyed(grid, ball.centre.head<2>() + end * along)) break;
    if (!(end > clear)) break;
    clear = end;
  }
  return clear;
}

}  // namespace clast::dem_detail
