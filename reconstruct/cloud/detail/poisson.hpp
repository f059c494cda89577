#pragma once
/// Indicator function of oriented points, and surface extraction.
#include <memory>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Indicator function of a body: negative inside and positive outside. It is the global solution of
/// a Poisson equation for oriented points. It is robust against outliers, gaps and varying density.
/// @cite kazhdan2006
class IndicatorFunction {
 public:
  /// Computes the indicator function of points.
  /// @param normals  unit normals, nearly all outward or nearly all inward
  IndicatorFunction(std::span<const Vec3> points, std::span<const Vec3> normals);
  ~IndicatorFunction();

  bool is_solved() const;  ///< false if the equations could not be solved
  double value_at(const Vec3& position) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  double facing_ = 1.0;  ///< -1 if most normals face inward
};

/// Extracts the closed surface between the Delaunay tetrahedra inside and outside the body, as
/// given by the indicator at their circumcentres. It is the restricted Delaunay triangulation, a
/// manifold for dense samples. Its vertices are points. It has one component, no cavities and no
/// self-intersections. Large triangles close it where there are no points.
/// @param spacings  local point spacings, m. If given, parts thinner than these are included, with
///                  their noise; if empty, they are not
/// @returns surface, outward; its vertices are all points in order, including unused ones; empty if
/// no tetrahedron is inside
/// @pre indicator.is_solved()
/// @cite amenta1999
TriangleMesh extract_surface(std::span<const Vec3> points, const IndicatorFunction& indicator,
                             std::span<const double> spacings = {});

}  // namespace clast::reconstruct_detail
