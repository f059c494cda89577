#pragma once
/// A smooth surface of heights over a plane.
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Heights at the nodes of a square grid, in between bilinear. Fitted by least squares to points,
/// with the bending of a thin plate as a penalty: it averages roughness, and carries on smoothly
/// where there are no points.
class ThinPlateGrid {
 public:
  /// @param points     (x, y, height), m
  /// @param nodes      along the longer side of the box that all of `extent` lies in
  /// @param stiffness  weight of the bending against the points of a mean node
  ThinPlateGrid(std::span<const Vec3> points, const Eigen::AlignedBox2d& extent, int nodes,
                double stiffness);

  double height_at(const Vec2& position) const;

 private:
  struct NodeWeight {
    std::size_t node;
    double weight;
  };
  std::array<NodeWeight, 4> interpolation_nodes(const Vec2& position) const;

  Vec2 low_;
  double cell_ = 1.0;
  std::size_t columns_ = 2, rows_ = 2;
  std::vector<double> heights_;
};

}  // namespace clast::reconstruct_detail
