#include "reconstruct/deposit/detail/convex_patches.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/disjoint_sets.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kGraphNeighbours = 8;  ///< edges to more would cross crevices
constexpr double kPersistence = 0.05;        ///< concavity by which basins must be separated

}  // namespace

ConvexPatches find_convex_patches(const OrientedPoints& cloud) {
  const std::vector<double>& c = cloud.concavities;
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return c[a] != c[b] ? c[a] < c[b] : a < b; });
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> basin(cloud.size(), kNone);
  std::vector<double> minimum;
  DisjointSets sets(cloud.size());  // of basins, of which there are at most as many as points
  const std::size_t degree = std::min(kGraphNeighbours, cloud.neighbour_count);
  for (const std::uint32_t i : order) {
    // The basin of the lowest neighbour, with which shallow basins around the point are joined.
    std::uint32_t lowest = kNone;
    const auto near = cloud.neighbours_of(i).first(degree);
    for (const std::uint32_t n : near) {
      if (basin[n] == kNone) continue;
      if (lowest == kNone || c[n] < c[lowest] || (c[n] == c[lowest] && n < lowest)) lowest = n;
    }
    if (lowest == kNone) {
      basin[i] = static_cast<std::uint32_t>(minimum.size());
      minimum.push_back(c[i]);
      continue;
    }
    std::uint32_t own = sets.find(basin[lowest]);
    basin[i] = own;
    for (const std::uint32_t n : near) {
      if (basin[n] == kNone) continue;
      const std::uint32_t other = sets.find(basin[n]);
      if (other == own) continue;
      if (c[i] - std::max(minimum[own], minimum[other]) >= kPersistence) continue;
      const double deepest = std::min(minimum[own], minimum[other]);
      sets.join(own, other);
      own = sets.find(own);
      minimum[own] = deepest;
    }
  }
  ConvexPatches patches;
  patches.patch_of_point.resize(cloud.size());
  std::vector<std::uint32_t> number(minimum.size(), kNone);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::uint32_t& n = number[sets.find(basin[i])];
    if (n == kNone) n = static_cast<std::uint32_t>(patches.count++);
    patches.patch_of_point[i] = n;
  }
  return patches;
}

}  // namespace clast::reconstruct_detail
