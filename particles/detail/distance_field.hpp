#pragma once
/// Signed distance to the surface of a body, interpolated on a grid.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "particles/detail/body_surface.hpp"

namespace clast::particles_detail {

/// Grid of signed distances. Nodes are computed when they are first needed, so that only those near
/// the evaluated points cost time. Values do not depend on the order of evaluation.
class DistanceField {
 public:
  /// @param surface  must outlive the field
  /// @param box  evaluated region; points outside are moved to its surface
  /// @param spacing  distance of the nodes, m
  DistanceField(const BodySurface& surface, const Bounds& box, double spacing);

  struct Value {
    double distance = 0.0;         ///< negative inside, m
    Vec3 gradient = Vec3::Zero();  ///< of the interpolated distance; about a unit vector
  };
  Value at(const Vec3& point);

 private:
  /// Nodes are stored in bricks of this length, so that those of a cell are near in memory.
  static constexpr std::size_t kBrick = 4;

  double node(std::size_t x, std::size_t y, std::size_t z);

  const BodySurface& surface_;
  Vec3 origin_;
  double spacing_;
  std::array<std::size_t, 3> size_;    ///< nodes
  std::array<std::size_t, 3> bricks_;  ///< numbers of bricks
  std::vector<float> values_;          ///< NaN until computed
  std::vector<std::uint32_t> hints_;   ///< triangle nearest to the last computed node of each brick
};

}  // namespace clast::particles_detail
