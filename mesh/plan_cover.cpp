#include "mesh/plan_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clast {
namespace {

constexpr double kCellsPerBody = 40.0;  ///< along the side of a body
constexpr double kMostCells = 4e6;
constexpr double kNoHeight = -std::numeric_limits<double>::infinity();

/// Grid of the heights of the highest body.
struct PlanGrid {
  Vec2 low = Vec2::Zero();
  double cell = 1.0;
  std::size_t columns = 1, rows = 1;
  std::vector<double> heights;
  std::vector<std::uint32_t> bodies;  ///< `kNoIndex` where there is none

  std::size_t first_after(double coordinate, double start, std::size_t count) const {
    const double cells = std::ceil((coordinate - start) / cell - 0.5);
    return static_cast<std::size_t>(std::clamp(cells, 0.0, static_cast<double>(count)));
  }
  Vec2 centre(std::size_t i, std::size_t j) const {
    return low + cell * Vec2(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
  }
};

PlanGrid make_plan_grid(std::span<const TriangleMesh* const> bodies) {
  Bounds all;
  std::vector<double> areas;
  for (const TriangleMesh* body : bodies) {
    const Bounds box = bounds(*body);
    all.include(box.low);
    all.include(box.high);
    areas.push_back((box.high - box.low).head<2>().prod());
  }
  PlanGrid grid;
  if (bodies.empty()) return grid;
  std::nth_element(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2),
                   areas.end());
  const Vec2 extent = (all.high - all.low).head<2>();
  const double smallest = std::sqrt(extent.prod() / kMostCells);
  grid.cell = std::max(std::sqrt(areas[areas.size() / 2]) / kCellsPerBody, smallest);
  grid.low = all.low.head<2>();
  grid.columns = static_cast<std::size_t>(extent.x() / grid.cell) + 1;
  grid.rows = static_cast<std::size_t>(extent.y() / grid.cell) + 1;
  grid.heights.assign(grid.columns * grid.rows, kNoHeight);
  grid.bodies.assign(grid.columns * grid.rows, kNoIndex);
  return grid;
}

/// Calls `visit(cell, height)` for the cells whose centres are in a triangle.
template <class Visit>
void visit_cells(const PlanGrid& grid, const Vec3& a, const Vec3& b, const Vec3& c, Visit visit) {
  const Vec2 u = (b - a).head<2>(), v = (c - a).head<2>();
  const double twice_area = u.x() * v.y() - u.y() * v.x();
  if (twice_area == 0.0) return;
  const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const std::size_t i_end = grid.first_after(high.x(), grid.low.x(), grid.columns);
  const std::size_t j_end = grid.first_after(high.y(), grid.low.y(), grid.rows);
  for (std::size_t j = grid.first_after(low.y(), grid.low.y(), grid.rows); j < j_end; ++j) {
    for (std::size_t i = grid.first_after(low.x(), grid.low.x(), grid.columns); i < i_end; ++i) {
      const Vec2 p = grid.centre(i, j) - a.head<2>();
      const double s = (p.x() * v.y() - p.y() * v.x()) / twice_area;
      const double t = (u.x() * p.y() - u.y() * p.x()) / twice_area;
      if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
      visit(j * grid.columns + i, a.z() + s * (b.z() - a.z()) + t * (c.z() - a.z()));
    }
  }
}

}  // namespace

std::vector<PlanCover> measure_plan_cover(std::span<const TriangleMesh* const> bodies) {
  PlanGrid grid = make_plan_grid(bodies);
  std::vector<PlanCover> covers(bodies.size());
  const double cell_area = grid.cell * grid.cell;
  std::vector<std::uint32_t> last(grid.bodies.size(), kNoIndex);  // body that was counted last
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    const TriangleMesh& body = *bodies[b];
    for (const TriangleMesh::Triangle& triangle : body.triangles) {
      visit_cells(grid, body.vertices[triangle[0]], body.vertices[triangle[1]],
                  body.vertices[triangle[2]], [&](std::size_t cell, double height) {
                    if (last[cell] != b) covers[b].area += cell_area;
                    last[cell] = b;
                    if (height <= grid.heights[cell]) return;
                    grid.heights[cell] = height;
                    grid.bodies[cell] = b;
                  });
    }
  }
  for (const std::uint32_t body : grid.bodies) {
    if (body != kNoIndex) covers[body].exposed += cell_area;
  }
  return covers;
}

}  // namespace clast
