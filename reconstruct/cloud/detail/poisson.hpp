#pragma once
/// Indicator function of oriented points, and surface extraction.
#include <memory>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Indicator function, negative inside and positive outside the body, solved globally from oriented
/// points [kazhdan2006] and so robust against single outliers, gaps and varying density.
/// @cite kazhdan2006
class IndicatorFunction {
 public:
  /// Solves for the function.
  /// @param normals  unit, outward, or nearly all inward
  IndicatorFunction(std::span<const Vec3> points, std::span<const Vec3> normals);
  ~IndicatorFunction();

  bool is_solved() const;  ///< false if the equations could not be solved
  double value_at(const Vec3& position) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  double facing_ = 1.0;  ///< -1 if most normals face inward
};

/// Extracts the closed surface that separates Delaunay tetrahedra inside and outside, by the
/// indicator at their circumcentres: the restricted Delaunay triangulation, a manifold for dense
/// samples. Its vertices are points, so that it stays in their hull. It has no self-intersections,
/// one component and no cavities, and is closed with large triangles where there are no points.
/// @param spacings  of the points, m: parts thinner than these are included, with their noise;
///                  empty: they are not
/// @returns outward; vertices are all points in order, including unused ones; empty if nothing is
///          inside
/// @pre indicator.found()
/// @cite amenta1999
TriangleMesh extract_surface(std::span<const Vec3> points, const IndicatorFunction& indicator,
                             std::span<const double> spacings = {});

}  // namespace clast::reconstruct_detail
