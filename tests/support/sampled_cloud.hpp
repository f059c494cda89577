#pragma once
/// Clouds of points on a closed surface, complete all round, as a scanner leaves them.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"
#include "tests/support/surface_sampler.hpp"

namespace clast {

/// How a complete cloud is drawn.
struct CloudSampling {
  std::size_t points = 8000;
  double noise = 0.0;     ///< standard deviation of every coordinate, m
  double fall = 1.0;      ///< density at the far end of `along` over that at the near end
  bool step = false;      ///< the density falls in one step, half way, and not evenly
  double outliers = 0.0;  ///< share of further points anywhere in the box grown by a tenth
  Vec3 along = Vec3::UnitX();
};

/// Points drawn at random, in proportion to area, from the surface of `mesh`.
inline std::vector<Vec3> sampled_cloud(const TriangleMesh& mesh, const CloudSampling& sampling,
                                       std::uint64_t seed) {
  Random random(seed);
  const SurfaceSampler surface(mesh);
  Bounds box;
  double low = 1e300, high = -1e300;
  for (const Vec3& v : mesh.vertices) {
    box.include(v);
    low = std::min(low, sampling.along.dot(v));
    high = std::max(high, sampling.along.dot(v));
  }
  std::vector<Vec3> points;
  while (points.size() < sampling.points) {
    const Vec3 p = surface.draw(random).point;
    const double share = (sampling.along.dot(p) - low) / (high - low);
    const double density =
        sampling.step ? (share < 0.5 ? 1.0 : sampling.fall) : 1.0 + share * (sampling.fall - 1.0);
    if (random.uniform() >= density) continue;
    const Vec3 off(random.normal(), random.normal(), random.normal());
    points.push_back(p + sampling.noise * off);
  }
  const Vec3 margin = 0.05 * (box.high - box.low);
  const auto strays =
      static_cast<std::size_t>(sampling.outliers * static_cast<double>(points.size()));
  for (std::size_t i = 0; i < strays; ++i) {
    const Vec3 share(random.uniform(), random.uniform(), random.uniform());
    points.push_back(box.low - margin + share.cwiseProduct(box.high - box.low + 2.0 * margin));
  }
  return points;
}

}  // namespace clast
