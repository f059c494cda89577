#pragma once
/// Point clouds of bodies of which every point is known.
#include <cstddef>
#include <functional>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// What a cloud is like. Lengths in metres.
struct CloudSample {
  std::size_t points = 8000;
  double noise = 0.0;     ///< standard deviation of every coordinate
  double outliers = 0.0;  ///< share of further points, anywhere in a box half as large again
  /// Probability that a point of the surface is kept; the others are drawn again.
  std::function<double(const Vec3&)> density = [](const Vec3&) { return 1.0; };
};

/// Points drawn uniformly by area, then thinned by the density.
std::vector<Vec3> sampled_cloud(const TriangleMesh& mesh, const CloudSample& sample,
                                Random& random);

/// Falls straight from 1 to `least` along `direction` over the extent of the mesh.
std::function<double(const Vec3&)> falling_density(const TriangleMesh& mesh, const Vec3& direction,
                                                   double least);
/// 1 on one half across `direction`, `least` on the other.
std::function<double(const Vec3&)> halved_density(const TriangleMesh& mesh, const Vec3& direction,
                                                  double least);

}  // namespace clast
