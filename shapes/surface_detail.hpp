#pragma once
/// Scaling of surface detail relative to the coarse shape.
#include "mesh/triangle_mesh.hpp"

namespace clast {

struct SurfaceDetailOptions {
  /// Factor of the detail: 0 gives the coarse shape, 1 the unchanged surface.
  double gain = 0.0;
  /// Largest spherical-harmonic degree of the coarse shape; shorter waves are detail.
  int degree = 6;

  void check() const;  ///< throws InputError naming the field and its value
};

enum class CoarseShape { kHarmonics, kBilaplacian };

struct DetailedSurface {
  TriangleMesh mesh;
  CoarseShape coarse = CoarseShape::kHarmonics;
};

/// Scales the surface detail; a gain of 1 returns the mesh unchanged.
///
/// For star-shaped surfaces, the radius r(u) about the star's centre is fitted by real spherical
/// harmonics up to `degree`, weighted by solid angle; the residual is the detail, and vertices move
/// along their rays. Otherwise the coarse shape is the surface after a bilaplacian filter, 1/(1 +
/// (k/k0)^2) for Laplacian eigenvalue k, where k0 is that of the same degree on a sphere of equal
/// area.
/// @param mesh  closed, outward, one component
/// @throws InputError  as `SurfaceDetailOptions::check`, or if there are too few vertices for the
///                     degree
/// @throws GeometryError  if a vertex would come too near the centre, or the surface would
///                        intersect itself
/// @cite garboczi2002
DetailedSurface scale_surface_detail(const TriangleMesh& mesh, const SurfaceDetailOptions& options);

}  // namespace clast
