#pragma once
/// Scaling of surface detail relative to the coarse shape.
#include "mesh/triangle_mesh.hpp"

namespace clast {

struct SurfaceDetailOptions {
  /// Factor by which the detail is scaled: 0 gives the coarse shape, 1 the unchanged surface.
  double gain = 0.0;
  /// Largest spherical-harmonic degree of the coarse shape. Higher degrees are detail.
  int degree = 6;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Method by which the coarse shape was computed: spherical harmonics or a bilaplacian filter.
enum class CoarseShapeMethod { kHarmonics, kBilaplacian };

struct ScaledDetailSurface {
  TriangleMesh mesh;
  CoarseShapeMethod coarse_shape_method = CoarseShapeMethod::kHarmonics;
};

/// Scales the surface detail. A gain of 1 returns the mesh unchanged.
///
/// For star-shaped surfaces, the radius about the star's centre is fitted by real spherical
/// harmonics up to `degree`, weighted by solid angle. The residual is the detail; vertices move
/// along their rays. For other surfaces, the coarse shape is found by the filter 1/(1 + (k/k0)^2)
/// for Laplacian eigenvalue k, where k0 is the eigenvalue of `degree` on a sphere of equal area.
/// @param mesh  closed, outward, one component
/// @throws InputError  as `SurfaceDetailOptions::check`, and for too few vertices for the degree
/// @throws GeometryError  if a vertex would come too near the centre, or if the surface would
///                        intersect itself
/// @cite garboczi2002
ScaledDetailSurface scale_surface_detail(const TriangleMesh& mesh,
                                         const SurfaceDetailOptions& options);

}  // namespace clast
