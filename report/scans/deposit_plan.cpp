#include "report/scans/deposit_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "mesh/plan_geometry.hpp"

namespace clast::report_detail {

namespace {

constexpr double kPlanCell = 1.3;         ///< least cell of a plan, in point spacings
constexpr double kMaxPlanCells = 700e3;   ///< of a plan, which bounds the size of a page
constexpr double kPlanStrays = 0.002;     ///< share of the points at each border of the window
constexpr int kGapRounds = 4;             ///< width of the gaps that are filled, in half cells
constexpr int kFewestNeighbours = 4;      ///< with points, of a cell that is filled
constexpr double kSmallestPolygon = 0.1;  ///< of the outline of a block, relative to the largest

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Window with all blocks and nearly all other points.
PlanWindow plan_window(std::span<const Vec3> points,
                       std::span<const std::uint32_t> block_of_point) {
  PlanWindow window;
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<double> values;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < points.size(); ++i) {
      values.push_back(points[i][axis]);
      if (block_of_point[i] == 0) continue;
      low = std::min(low, points[i][axis]);
      high = std::max(high, points[i][axis]);
    }
    const double first = quantile(values, kPlanStrays), last = quantile(values, 1.0 - kPlanStrays);
    const double margin = 0.01 * (last - first);
    window.low[axis] = std::min(low, first) - margin;
    window.high[axis] = std::max(high, last) + margin;
  }
  return window;
}

/// Gives empty cells the mean height and the most frequent block of their neighbours.
void fill_plan_gaps(DepositPlan& plan) {
  const auto columns = static_cast<long>(plan.relief.columns),
             rows = static_cast<long>(plan.relief.rows);
  const std::vector<double> heights = plan.relief.height;
  const std::vector<std::uint32_t> blocks = plan.blocks;
  for (long row = 0; row < rows; ++row) {
    for (long column = 0; column < columns; ++column) {
      const auto cell = static_cast<std::size_t>(row * columns + column);
      if (!std::isnan(heights[cell])) continue;
      double sum = 0.0;
      std::map<std::uint32_t, int> votes;
      int count = 0;
      for (long r = std::max(0L, row - 1); r <= std::min(rows - 1, row + 1); ++r) {
        for (long c = std::max(0L, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
          const auto other = static_cast<std::size_t>(r * columns + c);
          if (std::isnan(heights[other])) continue;
          sum += heights[other];
          ++votes[blocks[other]];
          ++count;
        }
      }
      if (count < kFewestNeighbours) continue;
      plan.relief.height[cell] = sum / count;
      plan.blocks[cell] =
          std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
            return a.second < b.second;
          })->first;
    }
  }
}

/// Cells that hold points, with a border of empty cells.
class PlanMask {
 public:
  PlanMask(std::span<const Vec2> points, double cell) : cell_(cell) {
    Vec2 high = points[0];
    low_ = points[0];
    for (const Vec2& p : points) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    low_ -= Vec2::Constant(kBorder * cell);
    columns_ = static_cast<long>((high.x() - low_.x()) / cell) + kBorder + 1;
    rows_ = static_cast<long>((high.y() - low_.y()) / cell) + kBorder + 1;
    filled_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
    for (const Vec2& p : points) {
      const Vec2 at = (p - low_) / cell;
      filled_[index(static_cast<long>(at.x()), static_cast<long>(at.y()))] = 1;
    }
    // Grown and shrunk by a cell, the mask has no gaps between neighbouring points.
    spread(1);
    spread(0);
  }

  bool at(long column, long row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ &&
           filled_[index(column, row)] == 1;
  }
  long columns() const { return columns_; }
  long rows() const { return rows_; }
  /// Position in units of half cells.
  Vec2 place(long x, long y) const {
    return low_ + 0.5 * cell_ * Vec2(static_cast<double>(x), static_cast<double>(y));
  }

 private:
  static constexpr int kBorder = 3;

  std::size_t index(long column, long row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  /// Gives cells a value if one of their eight neighbours has it.
  void spread(std::uint8_t value) {
    const std::vector<std::uint8_t> before = filled_;
    for (long row = 1; row + 1 < rows_; ++row) {
      for (long column = 1; column + 1 < columns_; ++column) {
        for (long r = row - 1; r <= row + 1; ++r) {
          for (long c = column - 1; c <= column + 1; ++c) {
            if (before[index(c, r)] == value) filled_[index(column, row)] = value;
          }
        }
      }
    }
  }

  double cell_;
  Vec2 low_;
  long columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> filled_;
};

/// Steps along the sides of cells: east, north, west, south.
constexpr std::array<std::array<long, 2>, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Sides of filled cells towards empty ones, with the filled cell on their left, by their start.
std::map<std::array<long, 2>, std::vector<std::size_t>> border_sides(const PlanMask& mask) {
  std::map<std::array<long, 2>, std::vector<std::size_t>> sides;
  for (long row = 0; row < mask.rows(); ++row) {
    for (long column = 0; column < mask.columns(); ++column) {
      if (!mask.at(column, row)) continue;
      if (!mask.at(column, row - 1)) sides[{column, row}].push_back(0);
      if (!mask.at(column + 1, row)) sides[{column + 1, row}].push_back(1);
      if (!mask.at(column, row + 1)) sides[{column + 1, row + 1}].push_back(2);
      if (!mask.at(column - 1, row)) sides[{column, row + 1}].push_back(3);
    }
  }
  return sides;
}

}  // namespace

DepositPlan make_deposit_plan(std::span<const Vec3> points,
                              std::span<const std::uint32_t> block_of_point, double spacing) {
  DepositPlan plan;
  plan.window = plan_window(points, block_of_point);
  const Vec2 size = plan.window.size();
  const double cell = std::max({kPlanCell * spacing, std::sqrt(size.prod() / kMaxPlanCells),
                                size.maxCoeff() / std::sqrt(kMaxPlanCells) / 4.0});
  Relief& relief = plan.relief;
  relief.cell = cell;
  relief.columns = static_cast<std::uint32_t>(size.x() / cell) + 1;
  relief.rows = static_cast<std::uint32_t>(size.y() / cell) + 1;
  plan.window.high.x() = plan.window.low.x() + cell * relief.columns;
  plan.window.low.y() = plan.window.high.y() - cell * relief.rows;
  const std::size_t cells = std::size_t{relief.columns} * relief.rows;
  relief.height.assign(cells, std::numeric_limits<double>::quiet_NaN());
  relief.zone.assign(cells, 0);
  plan.blocks.assign(cells, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double column = (points[i].x() - plan.window.low.x()) / cell,
                 row = (plan.window.high.y() - points[i].y()) / cell;
    if (column < 0.0 || row < 0.0 || column >= relief.columns || row >= relief.rows) continue;
    const std::size_t at =
        static_cast<std::size_t>(row) * relief.columns + static_cast<std::size_t>(column);
    if (relief.height[at] >= points[i].z()) continue;
    relief.height[at] = points[i].z();
    plan.blocks[at] = block_of_point[i];
  }
  for (int round = 0; round < kGapRounds; ++round) fill_plan_gaps(plan);
  return plan;
}

std::string render_plan_png(const DepositPlan& plan) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const double height : plan.relief.height) {
    if (!std::isnan(height)) lowest = std::min(lowest, height);
  }
  // All heights are in one contour band: contours of single blocks would hide their outlines.
  constexpr double kOneBand = 1e9;
  return render_relief_png(plan.relief, {}, 1.0 - lowest, kOneBand);
}

std::vector<std::vector<Vec2>> trace_plan_outlines(std::span<const Vec2> points, double cell) {
  if (points.empty()) return {};
  const PlanMask mask(points, cell);
  auto sides = border_sides(mask);
  std::vector<std::pair<double, std::vector<Vec2>>> polygons;
  while (!sides.empty()) {
    const std::array<long, 2> start = sides.begin()->first;
    std::array<long, 2> corner = start;
    std::size_t last = sides.begin()->second.front();
    std::vector<Vec2> polygon;
    std::size_t previous = 4;
    do {
      std::vector<std::size_t>& open = sides.at(corner);
      // Where two cells meet at a corner, the turn to the left stays with the same cell.
      auto next = std::find(open.begin(), open.end(), (last + 1) % 4);
      if (next == open.end()) next = open.begin();
      last = *next;
      open.erase(next);
      if (open.empty()) sides.erase(corner);
      const auto& [dx, dy] = kSteps[last];
      // Through the middles of the sides, so that stairs become slopes.
      if (last == previous) polygon.pop_back();
      polygon.push_back(mask.place(2 * corner[0] + dx, 2 * corner[1] + dy));
      if (last != previous) polygon.push_back(polygon.back());
      previous = last;
      corner = {corner[0] + dx, corner[1] + dy};
    } while (corner != start);
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    const double area = signed_area(polygon);
    if (area > 0.0) polygons.emplace_back(area, std::move(polygon));
  }
  std::stable_sort(polygons.begin(), polygons.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::vector<Vec2>> outlines;
  for (auto& [area, polygon] : polygons) {
    if (area >= kSmallestPolygon * polygons.front().first) outlines.push_back(std::move(polygon));
  }
  return outlines;
}

}  // namespace clast::report_detail
