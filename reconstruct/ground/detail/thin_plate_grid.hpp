#pragma once
/// Smooth height surface over a plane.
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Bilinear heights on a square grid, fitted to points by least squares. A thin-plate bending
/// penalty smooths the roughness and gives a smooth extrapolation.
class ThinPlateGrid {
 public:
  /// Fits a grid of heights to points.
  /// @param points  (x, y, height), m
  /// @param nodes  number of nodes along the longer side of `extent`
  /// @param stiffness  weight of the bending penalty relative to the points of an average node
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
