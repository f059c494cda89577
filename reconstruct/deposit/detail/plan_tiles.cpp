#include "reconstruct/deposit/detail/plan_tiles.hpp"

#include <algorithm>
#include <numeric>

namespace clast::reconstruct_detail {

namespace {

void divide_box(std::span<const Vec3> points, std::span<std::uint32_t> members, PlanBox box,
                std::size_t max_points, std::vector<PlanBox>& boxes) {
  if (members.size() <= max_points) {
    boxes.push_back(box);
    return;
  }
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const std::uint32_t i : members) {
    low = low.cwiseMin(points[i].head<2>());
    high = high.cwiseMax(points[i].head<2>());
  }
  const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
  std::nth_element(members.begin(), middle, members.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
  });
  const double cut = points[*middle][axis];
  if (!(cut > low[axis])) {  // half of the points are at one coordinate
    boxes.push_back(box);
    return;
  }
  const auto upper_half = std::partition(members.begin(), members.end(),
                                         [&](std::uint32_t i) { return points[i][axis] < cut; });
  PlanBox below = box, above = box;
  below.upper[axis] = above.lower[axis] = cut;
  divide_box(points, {members.begin(), upper_half}, below, max_points, boxes);
  divide_box(points, {upper_half, members.end()}, above, max_points, boxes);
}

}  // namespace

std::vector<PlanBox> divide_in_plan(std::span<const Vec3> points, std::size_t max_points) {
  std::vector<std::uint32_t> members(points.size());
  std::iota(members.begin(), members.end(), 0u);
  std::vector<PlanBox> boxes;
  divide_box(points, members, {}, max_points, boxes);
  return boxes;
}

std::vector<std::uint32_t> find_points_within(std::span<const Vec3> points, const PlanBox& box) {
  std::vector<std::uint32_t> inside;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (box.contains(points[i])) inside.push_back(i);
  }
  return inside;
}

}  // namespace clast::reconstruct_detail
