#include "reconstruct/cloud/separate_sets.hpp"

#include <algorithm>
#include <cstdint>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/outliers.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Cell size over the diagonal; sets are separated on a decimated cloud.
constexpr double kSetDecimationCell = 1.0 / 150.0;
/// Maximum distance between neighbouring points of a set: 3 cells, or 4 times the 0.98 quantile of
/// the point spacings.
constexpr double kSetReach = 3.0;
constexpr double kSetSpacings = 4.0, kThinnestSet = 0.98;
constexpr double kNear = 0.25;  ///< of the largest set's diagonal

bool meet(const Bounds& a, const Bounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

SeparatedPoints separate_far_points(std::span<const Vec3> points) {
  SeparatedPoints result;
  result.near_points.assign(points.begin(), points.end());
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  const double cell = kSetDecimationCell * box.diagonal();
  if (points.empty() || !(cell > 0.0)) return result;
  const std::vector<Vec3> sparse = decimate_points(points, cell);
  if (sparse.size() < 8) return result;
  std::vector<double> spacings = compute_local_spacings(sparse);
  const auto sparsest = spacings.begin() + static_cast<std::ptrdiff_t>(
                                               kThinnestSet * static_cast<double>(spacings.size()));
  std::nth_element(spacings.begin(), sparsest, spacings.end());
  const double reach = std::max(kSetReach * cell, kSetSpacings * *sparsest);
  const std::vector<std::vector<std::uint32_t>> sets = find_clusters(sparse, reach, 1);
  if (sets.size() < 2) return result;

  Bounds around;
  for (const std::uint32_t i : sets[0]) around.include(sparse[i]);
  const Vec3 margin = Vec3::Constant(kNear * around.diagonal());
  around.low -= margin;
  around.high += margin;
  std::vector<bool> is_far(sparse.size(), false);
  bool any = false;
  for (std::size_t s = 1; s < sets.size(); ++s) {
    Bounds own;
    for (const std::uint32_t i : sets[s]) own.include(sparse[i]);
    if (meet(own, around)) continue;
    for (const std::uint32_t i : sets[s]) is_far[i] = true;
    if (any) continue;  // the largest far set comes first
    any = true;
    result.far_area_ratio =
        static_cast<double>(sets[s].size()) / static_cast<double>(sets[0].size());
    result.far_position = sparse[sets[s].front()];
  }
  if (!any) return result;
  result.near_points.clear();
  const PointTree tree(sparse);
  for (const Vec3& p : points) {
    if (is_far[tree.nearest_neighbours(p, 1).front().point]) {
      ++result.far_count;
    } else {
      result.near_points.push_back(p);
    }
  }
  return result;
}

}  // namespace clast::reconstruct_detail
