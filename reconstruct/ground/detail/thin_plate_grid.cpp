#include "reconstruct/ground/detail/thin_plate_grid.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace clast::reconstruct_detail {

namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// Bending energy of a thin plate on a grid: squared second differences, both axes and mixed.
void add_bending(Entries& entries, std::size_t columns, std::size_t rows, double weight) {
  struct Term {
    std::size_t node;
    double factor;
  };
  const auto add_bending_term = [&](std::initializer_list<Term> terms, double coefficient) {
    for (const Term& a : terms) {
      for (const Term& b : terms) {
        entries.emplace_back(a.node, b.node, coefficient * weight * a.factor * b.factor);
      }
    }
  };
  const auto node = [&](std::size_t i, std::size_t j) { return j * columns + i; };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      if (i + 2 < columns) {
        add_bending_term({{node(i, j), 1.0}, {node(i + 1, j), -2.0}, {node(i + 2, j), 1.0}}, 1.0);
      }
      if (j + 2 < rows) {
        add_bending_term({{node(i, j), 1.0}, {node(i, j + 1), -2.0}, {node(i, j + 2), 1.0}}, 1.0);
      }
      if (i + 1 < columns && j + 1 < rows) {
        add_bending_term({{node(i, j), 1.0},
                          {node(i + 1, j), -1.0},
                          {node(i, j + 1), -1.0},
                          {node(i + 1, j + 1), 1.0}},
                         2.0);
      }
    }
  }
}

}  // namespace

ThinPlateGrid::ThinPlateGrid(std::span<const Vec3> points, const Eigen::AlignedBox2d& extent,
                             int nodes, double stiffness) {
  const Vec2 size = extent.sizes();
  cell_ = std::max(size.maxCoeff() / (nodes - 1), 1e-300);
  low_ = extent.min();
  columns_ = static_cast<std::size_t>(std::ceil(size.x() / cell_)) + 2;
  rows_ = static_cast<std::size_t>(std::ceil(size.y() / cell_)) + 2;
  const auto count = static_cast<Eigen::Index>(columns_ * rows_);

  Entries entries;
  Eigen::VectorXd side = Eigen::VectorXd::Zero(count);
  for (const Vec3& point : points) {
    const std::array<NodeWeight, 4> around = interpolation_nodes(point.head<2>());
    for (const NodeWeight& a : around) {
      side[static_cast<Eigen::Index>(a.node)] += a.weight * point.z();
      for (const NodeWeight& b : around) {
        entries.emplace_back(a.node, b.node, a.weight * b.weight);
      }
    }
  }
  const double weight =
      stiffness * std::max(1.0, static_cast<double>(points.size()) / static_cast<double>(count));
  add_bending(entries, columns_, rows_, weight);
  // Fewer than three points leave the plate free to tilt.
  for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, 1e-9 * weight);
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd solution = solver.solve(side);
  heights_.assign(solution.begin(), solution.end());
}

std::array<ThinPlateGrid::NodeWeight, 4> ThinPlateGrid::interpolation_nodes(
    const Vec2& position) const {
  const auto cell_of = [&](double x, std::size_t nodes) {
    return std::clamp(x, 0.0, static_cast<double>(nodes - 1) - 1e-9);
  };
  const double x = cell_of((position.x() - low_.x()) / cell_, columns_);
  const double y = cell_of((position.y() - low_.y()) / cell_, rows_);
  const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
  const double u = x - static_cast<double>(i), v = y - static_cast<double>(j);
  const std::size_t first = j * columns_ + i;
  return {{{first, (1 - u) * (1 - v)},
           {first + 1, u * (1 - v)},
           {first + columns_, (1 - u) * v},
           {first + columns_ + 1, u * v}}};
}

double ThinPlateGrid::height_at(const Vec2& position) const {
  double height = 0.0;
  for (const NodeWeight& corner : interpolation_nodes(position))
    height += corner.weight * heights_[corner.node];
  return height;
}

}  // namespace clast::reconstruct_detail
