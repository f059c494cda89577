#include "study/simulate/detail/covered_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/plane.hpp"

namespace clast::study_detail {
namespace {

/// The cells that a body may reach, in one block of rows.
class Cells {
 public:
  Cells(const Bounds& box, double radius, double width)
      : radius_(radius),
        width_(width),
        low_{cell_of(box.low.x() - radius), cell_of(box.low.y() - radius)},
        high_{cell_of(box.high.x() + radius), cell_of(box.high.y() + radius)} {
    const std::int64_t count = (high_[0] - low_[0] + 1) * (high_[1] - low_[1] + 1);
    cells_.resize(static_cast<std::size_t>(count));
    for (CoveredCell& cell : cells_) {
      cell.lowest = std::numeric_limits<double>::infinity();
      cell.highest = -cell.lowest;
    }
  }

  void include(const std::vector<Vec3>& triangle) {
    for_each_slab(triangle, 1, [&](std::int64_t j, const std::vector<Vec3>& row) {
      for_each_slab(row, 0, [&](std::int64_t i, const std::vector<Vec3>& piece) {
        const std::int64_t at = (j - low_[1]) * (high_[0] - low_[0] + 1) + i - low_[0];
        CoveredCell& cell = cells_[static_cast<std::size_t>(at)];
        cell.i = i;
        cell.j = j;
        for (const Vec3& point : piece) {
          cell.lowest = std::min(cell.lowest, point.z() - radius_);
          cell.highest = std::max(cell.highest, point.z() + radius_);
        }
      });
    });
  }

  std::vector<CoveredCell> covered() const {
    std::vector<CoveredCell> covered;
    for (const CoveredCell& cell : cells_) {
      if (cell.lowest <= cell.highest) covered.push_back(cell);
    }
    return covered;
  }

 private:
  std::int64_t cell_of(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(coordinate / width_));
  }

  /// The parts of a polygon in and around each row (axis 1) or column (axis 0) of cells.
  template <class Visit>
  void for_each_slab(const std::vector<Vec3>& polygon, int axis, const Visit& visit) const {
    if (polygon.empty()) return;
    double low = polygon[0][axis], high = low;
    for (const Vec3& point : polygon) {
      low = std::min(low, point[axis]);
      high = std::max(high, point[axis]);
    }
    for (std::int64_t k = cell_of(low - radius_); k <= cell_of(high + radius_); ++k) {
      const double from = static_cast<double>(k) * width_ - radius_;
      const double to = static_cast<double>(k + 1) * width_ + radius_;
      visit(k, clip_polygon_below(clip_polygon_below(polygon, {-Vec3::Unit(axis), -from}),
                                  {Vec3::Unit(axis), to}));
    }
  }

  double radius_, width_;
  std::int64_t low_[2], high_[2];
  std::vector<CoveredCell> cells_;
};

}  // namespace

std::vector<CoveredCell> compute_covered_cells(const TriangleMesh& core, double radius,
                                               const Pose& place, double width) {
  const TriangleMesh placed = transformed(core, place);
  Cells cells(bounds(placed), radius, width);
  for (const TriangleMesh::Triangle& triangle : placed.triangles) {
    cells.include(
        {placed.vertices[triangle[0]], placed.vertices[triangle[1]], placed.vertices[triangle[2]]});
  }
  return cells.covered();
}

}  // namespace clast::study_detail
