#pragma once
/// The surface between inside and outside that oriented points define.
#include <memory>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// A function that is negative inside and positive outside the body whose surface oriented points
/// lie on, solved for over all of them [kazhdan2006]: single points off the surface, gaps and
/// changes of density have little effect.
/// @cite kazhdan2006
class IndicatorFunction {
 public:
  /// @param normals  unit, outward, or nearly all inward
  IndicatorFunction(std::span<const Vec3> points, std::span<const Vec3> normals);
  ~IndicatorFunction();

  bool is_solved() const;  ///< false where the equations could not be solved
  double value_at(const Vec3& position) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  double facing_ = 1.0;  ///< -1 where most normals face inward
};

/// The closed surface through the points that separates the Delaunay tetrahedra inside from those
/// outside, by the indicator at their circumcentres: the restricted Delaunay triangulation, which
/// of a sample dense enough is a manifold. The surface has no vertex but the points, so it never
/// leaves their hull; points off it are no vertices. It crosses itself nowhere, is in one component
/// without cavities, and closed also where no points are: there its triangles are large.
/// @param spacings  of the points, m: parts thinner than that are taken in, as far as points lie on
///                  them, and noise with them; empty: they are not
/// @returns outward; vertices are all points in order, also those not used; empty when nothing is
///          inside
/// @pre indicator.is_solved()
/// @cite amenta1999
TriangleMesh extract_surface(std::span<const Vec3> points, const IndicatorFunction& indicator,
                             std::span<const double> spacings = {});

}  // namespace clast::reconstruct_detail
