#include "dem/search/broad_phase.hpp"

#include <algorithm>
#include <numeric>

namespace clast::dem_detail {
namespace {

/// Returns the axis with the largest extent of the spheres, along which they are sorted.
int widest_axis(std::span<const BoundingSphere> spheres) {
  Vec3 mean = Vec3::Zero(), spread = Vec3::Zero();
  for (const BoundingSphere& sphere : spheres) mean += sphere.centre;
  mean /= static_cast<double>(spheres.size());
  for (const BoundingSphere& sphere : spheres) {
    spread += (sphere.centre - mean).cwiseAbs2();
  }
  int axis = 0;
  spread.maxCoeff(&axis);
  return axis;
}

}  // namespace

bool BroadPhase::update_pairs(std::span<const BoundingSphere> spheres, double slack,
                              std::optional<std::span<const std::uint32_t>> moved) {
  const auto holds = [&](std::size_t i) {
    return (spheres[i].centre - centres_[i]).squaredNorm() <= 0.25 * slack * slack;
  };
  bool valid = centres_.size() == spheres.size();
  const std::size_t looked_at = moved ? moved->size() : spheres.size();
  for (std::size_t i = 0; valid && i < looked_at; ++i) valid = holds(moved ? (*moved)[i] : i);
  if (valid) return false;
  centres_.clear();
  for (const BoundingSphere& sphere : spheres) centres_.push_back(sphere.centre);
  pairs_.clear();
  if (spheres.empty()) return true;

  const int axis = widest_axis(spheres);
  const auto start = [&](std::uint32_t i) { return spheres[i].centre[axis] - spheres[i].radius; };
  std::vector<std::uint32_t> order(spheres.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return start(i) < start(j) || (start(i) == start(j) && i < j);
  });
  for (std::size_t first = 0; first < order.size(); ++first) {
    const BoundingSphere& a = spheres[order[first]];
    const double end = a.centre[axis] + a.radius + slack;
    for (std::size_t second = first + 1; second < order.size(); ++second) {
      if (start(order[second]) > end) break;
      const BoundingSphere& b = spheres[order[second]];
      const double reach = a.radius + b.radius + slack;
      if ((a.fixed && b.fixed) || (a.centre - b.centre).squaredNorm() > reach * reach) continue;
      pairs_.push_back(
          {std::min(order[first], order[second]), std::max(order[first], order[second])});
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return true;
}

}  // namespace clast::dem_detail
