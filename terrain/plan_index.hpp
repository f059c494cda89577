#pragma once
/// Things found by where they lie on the map.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// A box in plan, m.
struct PlanBox {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);

  void include(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  PlanBox expanded(double by) const { return {low.array() - by, high.array() + by}; }
};

/// Boxes in square cells. Each is listed once in every cell it reaches into.
class PlanIndex {
 public:
  explicit PlanIndex(std::span<const PlanBox> boxes);

  /// Numbers of the boxes in the cell around a point, rising; all boxes that hold it are among
  /// them.
  std::span<const std::uint32_t> boxes_near(const Vec2& point) const;
  /// Numbers of the boxes that may touch `box`, rising, each once.
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

/// The plan boxes of the triangles of a mesh.
std::vector<PlanBox> plan_boxes(const TriangleMesh& mesh);

/// Height of a triangle on the vertical through a point of the plan; none beside it (its edges
/// belong to it) and for upright triangles.
std::optional<double> height_on_triangle(const TriangleMesh& mesh, std::uint32_t triangle,
                                         const Vec2& at);

}  // namespace clast::terrain_detail
