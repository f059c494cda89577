#pragma once
/// Growing set of points with queries of the points near a place.
#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Points in a hashed grid of cubic cells.
class PointGrid {
 public:
  /// @param cell  size of the cells, m; queries have at most this radius
  explicit PointGrid(double cell);

  /// Adds a point and returns its index, counted from 0.
  std::uint32_t add(const Vec3& point);
  std::size_t size() const { return points_.size(); }

  /// Calls `visit(index)` for every point within `radius` of `place`, until it returns true.
  /// @return true if `visit` did
  template <class Visit>
  bool any_within(const Vec3& place, double radius, const Visit& visit) const {
    // Most places that are near a point have it in their own cell.
    const Eigen::Vector3i own = cell_of(place);
    const auto visit_cell = [&](const Eigen::Vector3i& cell) {
      for (std::uint32_t i = first_[bucket(cell)]; i != kNoIndex; i = next_[i]) {
        if (cells_[i] != cell) continue;
        if ((points_[i] - place).squaredNorm() <= radius * radius && visit(i)) return true;
      }
      return false;
    };
    if (visit_cell(own)) return true;
    const Eigen::Vector3i low = cell_of(place - Vec3::Constant(radius));
    const Eigen::Vector3i high = cell_of(place + Vec3::Constant(radius));
    for (int x = low.x(); x <= high.x(); ++x) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int z = low.z(); z <= high.z(); ++z) {
          const Eigen::Vector3i cell(x, y, z);
          if (cell != own && visit_cell(cell)) return true;
        }
      }
    }
    return false;
  }
  bool has_point_within(const Vec3& place, double radius) const {
    return any_within(place, radius, [](std::uint32_t) { return true; });
  }

 private:
  Eigen::Vector3i cell_of(const Vec3& point) const {
    return (point / cell_).array().floor().matrix().cast<int>();
  }
  std::size_t bucket(const Eigen::Vector3i& cell) const {
    const std::uint64_t mixed = static_cast<std::uint64_t>(cell.x()) * 0x9e3779b97f4a7c15u ^
                                static_cast<std::uint64_t>(cell.y()) * 0xc2b2ae3d27d4eb4fu ^
                                static_cast<std::uint64_t>(cell.z()) * 0x165667b19e3779f9u;
    return static_cast<std::size_t>(mixed >> 20) & (first_.size() - 1);
  }
  void grow();

  double cell_;
  std::vector<Vec3> points_;
  std::vector<Eigen::Vector3i> cells_;  ///< of the points
  std::vector<std::uint32_t> first_;  ///< first point of each bucket; their number is a power of 2
  std::vector<std::uint32_t> next_;   ///< next point of the same bucket
};

}  // namespace clast
