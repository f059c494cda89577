#include "reconstruct/registration/detail/even_subset.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

std::vector<std::uint32_t> choose_one_per_cell(std::span<const Vec3> points, double cell) {
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  std::set<std::tuple<long, long, long>> taken;
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 at = (points[i] - box.low) / cell;
    if (taken.emplace(std::lround(at.x()), std::lround(at.y()), std::lround(at.z())).second) {
      chosen.push_back(i);
    }
  }
  return chosen;
}

std::vector<std::uint32_t> choose_even_subset(std::span<const Vec3> points, std::size_t count) {
  if (points.size() <= count) {
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  constexpr double kGrowth = 1.05;
  double cell = box.diagonal() / std::sqrt(static_cast<double>(count)) / 2.0;
  std::vector<std::uint32_t> chosen = choose_one_per_cell(points, cell);
  while (chosen.size() > count) {
    cell *= kGrowth;
    chosen = choose_one_per_cell(points, cell);
  }
  return chosen;
}

}  // namespace clast::reconstruct_detail
