#pragma once
/// Spatial index of boxes in plan.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// Axis-aligned box in plan, m.
struct PlanBox {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);

  void include(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  PlanBox expanded(double by) const { return {low.array() - by, high.array() + by}; }
};

/// Uniform grid of plan boxes. Each box is listed in all cells that it overlaps.
class PlanIndex {
 public:
  explicit PlanIndex(std::span<const PlanBox> boxes);

  /// Returns the ascending indices of all boxes listed in the cell of a point. Every box that
  /// contains the point is among them.
  std::span<const std::uint32_t> boxes_near(const Vec2& point) const;
  /// Returns the ascending indices of the boxes that may overlap `box`.
  std::vector<std::uint32_t> boxes_near(const PlanBox& box) const;

 private:
  struct Range {
    long first_column, last_column, first_row, last_row;
  };
  Range range(const PlanBox& box) const;

  PlanBox extent_;
  double size_ = 1.0;
  long columns_ = 0, rows_ = 0;
  std::vector<std::uint64_t> offsets_;
  std::vector<std::uint32_t> numbers_;
};

std::vector<PlanBox> plan_boxes(const TriangleMesh& mesh);

/// Returns the height of a triangle at a plan point, m; empty if the point is outside or the
/// triangle is vertical. Edges belong to the triangle.
std::optional<double> height_on_triangle(const TriangleMesh& mesh, std::uint32_t triangle,
                                         const Vec2& at);

}  // namespace clast::terrain_detail
