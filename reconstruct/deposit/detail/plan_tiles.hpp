#pragma once
/// Division of large clouds into tiles in plan.
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Rectangle in plan, without its upper sides; sides may be infinite.
struct PlanBox {
  Vec2 lower = Vec2::Constant(-std::numeric_limits<double>::infinity());
  Vec2 upper = Vec2::Constant(std::numeric_limits<double>::infinity());

  bool contains(const Vec3& point) const {
    return (point.head<2>().array() >= lower.array()).all() &&
           (point.head<2>().array() < upper.array()).all();
  }
  /// True if the box is the whole plane.
  bool is_unbounded() const { return (upper.array().min(-lower.array()).isInf()).all(); }
  /// Returns a box whose sides are farther outside by `distance`.
  PlanBox expanded(double distance) const {
    return {lower - Vec2::Constant(distance), upper + Vec2::Constant(distance)};
  }
};

/// Divides the plane into boxes with at most `max_points` points each: a box with more is divided
/// at the median of the coordinate that its points spread most along. The outer sides of the boxes
/// are infinite.
std::vector<PlanBox> divide_in_plan(std::span<const Vec3> points, std::size_t max_points);

/// Returns the ascending indices of the points in a box.
std::vector<std::uint32_t> find_points_within(std::span<const Vec3> points, const PlanBox& box);

}  // namespace clast::reconstruct_detail
