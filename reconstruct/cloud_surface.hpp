#pragma once
/// Points of one block to a surface, open where nobody saw it.
#include <span>

#include "shapes/triangle_mesh.hpp"

namespace clast {

/// How a surface is put through points. Lengths are shares of the diagonal of the points.
struct CloudSurfaceOptions {
  double cell = 0.008;  ///< points are averaged in cubes of this side, or of twice their spacing
  int neighbours = 18;  ///< of the averaged points, for normals
  double edge = 1.5;    ///< edges of triangles, times the distance between averaged points
  double trim = 1.5;    ///< surface farther than this many cells from the points was not seen
  std::size_t fewest = 500;  ///< fewer points make no block

  void check() const;  ///< throws InputError naming the field and its value
};

/// Averages the points, turns their normals outward from neighbour to neighbour (Hoppe & al. 1992),
/// solves for the Poisson surface [kazhdan2006] and cuts away what no points support; small gaps
/// between points stay closed.
/// @param points  of one block, without outliers
/// @returns an oriented 2-manifold in one piece, outward; closed where points are all around
/// @throws InputError     too few points
/// @throws GeometryError  the points lie in a plane or on a line, or no surface was found
/// @cite hoppe1992 @cite kazhdan2006
TriangleMesh cloud_surface(std::span<const Vec3> points, const CloudSurfaceOptions& options = {});

}  // namespace clast
