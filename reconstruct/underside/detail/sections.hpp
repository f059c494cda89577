#pragma once
/// Level sections of a closed mesh.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Areas and volumes over the height along a direction. Keeps the heights and plan coordinates of
/// the mesh about its own middle.
class LevelSections {
 public:
  /// @param mesh  closed and outward
  /// @param up    unit
  LevelSections(const TriangleMesh& mesh, const Vec3& up);

  double min_height() const { return lowest_; }  ///< height along `up` of the lowest vertex, m
  double max_height() const { return highest_; }
  /// Area of the section at a height, m^2.
  double area(double height) const;
  /// Volume of the part above a height, m^3.
  double volume_above(double height) const;

 private:
  TriangleMesh mesh_;  ///< turned so that `up` is z
  Vec3 origin_;
  double offset_ = 0.0;  ///< height of the middle
  double lowest_ = 0.0, highest_ = 0.0;
};

}  // namespace clast::reconstruct_detail
