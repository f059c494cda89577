#include "terrain/input/detail/grid_holes.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace clast::terrain_detail {
namespace {

struct Hole {
  std::vector<std::size_t> cells;
  std::size_t low_column, high_column, low_row, high_row;
  bool at_border = false;
};

/// The empty cells joined to `seed`, which are marked in `seen`.
Hole hole_at(const HeightGrid& grid, std::size_t seed, std::vector<bool>& seen) {
  Hole hole{
      {seed}, seed % grid.columns, seed % grid.columns, seed / grid.columns, seed / grid.columns};
  seen[seed] = true;
  for (std::size_t k = 0; k < hole.cells.size(); ++k) {
    const std::size_t cell = hole.cells[k];
    const std::size_t i = cell % grid.columns, j = cell / grid.columns;
    hole.low_column = std::min(hole.low_column, i);
    hole.high_column = std::max(hole.high_column, i);
    hole.low_row = std::min(hole.low_row, j);
    hole.high_row = std::max(hole.high_row, j);
    const auto visit = [&](bool inside, std::size_t next) {
      if (!inside) {
        hole.at_border = true;
      } else if (!seen[next] && !std::isfinite(grid.heights[next])) {
        seen[next] = true;
        hole.cells.push_back(next);
      }
    };
    visit(i > 0, cell - 1);
    visit(i + 1 < grid.columns, cell + 1);
    visit(j > 0, cell - grid.columns);
    visit(j + 1 < grid.rows, cell + grid.columns);
  }
  return hole;
}

/// `number` is kNoIndex everywhere, before and after.
void fill(HeightGrid& grid, const Hole& hole, std::vector<std::uint32_t>& number) {
  const auto count = static_cast<Eigen::Index>(hole.cells.size());
  for (std::size_t k = 0; k < hole.cells.size(); ++k) {
    number[hole.cells[k]] = static_cast<std::uint32_t>(k);
  }
  const double along_x = 1.0 / (grid.cell_size.x() * grid.cell_size.x());
  const double along_y = 1.0 / (grid.cell_size.y() * grid.cell_size.y());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(5 * hole.cells.size());
  Eigen::VectorXd rim = Eigen::VectorXd::Zero(count);
  // Heights from one rim cell, so that those of high mountains lose no digits.
  double datum = std::numeric_limits<double>::quiet_NaN();
  for (Eigen::Index row = 0; row < count; ++row) {
    const std::size_t cell = hole.cells[static_cast<std::size_t>(row)];
    const std::array<std::pair<std::size_t, double>, 4> around = {{{cell - 1, along_x},
                                                                   {cell + 1, along_x},
                                                                   {cell - grid.columns, along_y},
                                                                   {cell + grid.columns, along_y}}};
    for (const auto& [next, weight] : around) {
      if (number[next] != kNoIndex) {
        entries.emplace_back(row, number[next], -weight);
        continue;
      }
      if (!std::isfinite(datum)) datum = grid.heights[next];
      rim[row] += weight * (grid.heights[next] - datum);
    }
    entries.emplace_back(row, row, 2.0 * (along_x + along_y));
  }
  Eigen::SparseMatrix<double> membrane(count, count);
  membrane.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(membrane);
  const Eigen::VectorXd heights = solver.solve(rim);
  for (Eigen::Index row = 0; row < count; ++row) {
    const std::size_t cell = hole.cells[static_cast<std::size_t>(row)];
    number[cell] = kNoIndex;
    grid.heights[cell] = datum + heights[row];
  }
}

}  // namespace

HoleFillReport fill_grid_holes(HeightGrid& grid, double widest) {
  HoleFillReport result;
  std::vector<bool> seen(grid.heights.size(), false);
  std::vector<std::uint32_t> number(grid.heights.size(), kNoIndex);
  for (std::size_t cell = 0; cell < grid.heights.size(); ++cell) {
    if (seen[cell] || std::isfinite(grid.heights[cell])) continue;
    const Hole hole = hole_at(grid, cell, seen);
    if (hole.at_border) continue;
    const Vec2 low = grid.centre(hole.low_column, hole.low_row);
    const Vec2 high = grid.centre(hole.high_column, hole.high_row);
    const double width = (high - low + grid.cell_size).maxCoeff();
    if (width <= widest * (1.0 + 1e-9)) {
      fill(grid, hole, number);
      ++result.holes;
      result.cells += hole.cells.size();
      continue;
    }
    ++result.remaining;
    if (width <= result.widest_remaining) continue;
    result.widest_remaining = width;
    const Vec2 middle = (low + high) / 2.0;
    result.widest_position = {middle.x(), middle.y(), 0.0};
  }
  return result;
}

}  // namespace clast::terrain_detail
