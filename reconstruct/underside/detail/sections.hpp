#pragma once
/// Horizontal sections of closed meshes.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Areas of sections, and volumes above them, as functions of the height along a direction.
class HorizontalSections {
 public:
  /// Prepares the horizontal sections of a mesh.
  /// @param mesh  closed and outward
  /// @param up  unit vector
  HorizontalSections(const TriangleMesh& mesh, const Vec3& up);

  double min_height() const { return lowest_; }  ///< height of the lowest vertex along `up`, m
  double max_height() const { return highest_; }
  /// Returns the area of the horizontal section at a height, m^2.
  double area(double height) const;
  /// Returns the volume of the mesh above a height, m^3.
  double volume_above(double height) const;

 private:
  TriangleMesh mesh_;  ///< rotated so that `up` is z
  Vec3 origin_;
  double offset_ = 0.0;  ///< height of the origin of `mesh_`
  double lowest_ = 0.0, highest_ = 0.0;
};

}  // namespace clast::reconstruct_detail
