#pragma once
/// Fast search for a nearest point of an observed surface.
#include <array>
#include <cstdint>
#include <vector>

#include "reconstruct/registration/oriented_surface.hpp"

namespace clast::reconstruct_detail {

/// Cubic cells, each with a near point of the surface. A search starts from the point of the cell
/// and descends over the neighbours of points.
class NearestGrid {
 public:
  /// @param surface  must outlive this object
  explicit NearestGrid(const OrientedSurface& surface);

  /// Returns the point of the cell: near, but rarely the nearest.
  std::uint32_t near_point(const Vec3& position) const { return near_[cell_at(position)]; }
  /// Returns a point that is nearest, or, far from the surface, nearly so.
  std::uint32_t nearest_point(const Vec3& position) const;

 private:
  std::size_t cell_at(const Vec3& position) const;
  void propagate();

  const OrientedSurface& surface_;
  Vec3 low_ = Vec3::Zero();
  double cell_ = 1.0;                ///< side of the cells, m
  std::array<int, 3> counts_ = {};   ///< number of cells along x, y, z
  std::vector<std::uint32_t> near_;  ///< point per cell
};

}  // namespace clast::reconstruct_detail
