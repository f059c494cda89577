#pragma once
/// The detail of a surface made weaker or stronger over its coarse form.
#include "mesh/triangle_mesh.hpp"

namespace clast {

struct SurfaceDetailOptions {
  /// What the detail is multiplied by: 0 leaves the coarse form, 1 the surface as it is.
  double gain = 0.0;
  /// Spherical harmonics up to this degree are the coarse form; bumps of more waves around the body
  /// are detail.
  int degree = 6;

  void check() const;  ///< throws InputError naming the field and its value
};

/// What was taken for the coarse form.
enum class CoarseShape { kHarmonics, kBilaplacian };

struct DetailedSurface {
  TriangleMesh mesh;
  CoarseShape coarse = CoarseShape::kHarmonics;
};

/// The surface with its detail multiplied; a gain of 1 returns it to the bit.
///
/// Star-shaped: the distance r(u) of the surface from the star's centre, at the vertices'
/// directions u, is fitted by real spherical harmonics up to `degree`, by least squares weighted
/// with the solid angles; what is left is the detail, and vertices move along their rays. Else the
/// coarse form is the surface after a bilaplacian filter, 1/(1 + (k/k0)^2) of each mode of the
/// mesh's Laplacian k, where k0 is that of waves of this degree around a ball of equal area.
/// @param mesh  closed, outward, one component
/// @throws InputError     as `SurfaceDetailOptions::check`; a degree for which there are too few vertices
/// @throws GeometryError  the detail is so strong that a vertex would come near the star's centre,
///                        or that the surface would cross itself
/// @cite garboczi2002
DetailedSurface scale_surface_detail(const TriangleMesh& mesh, const SurfaceDetailOptions& options);

}  // namespace clast
