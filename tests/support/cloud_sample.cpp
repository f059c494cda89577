#include "tests/support/cloud_sample.hpp"

#include <algorithm>

#include "tests/support/surface_sampler.hpp"

namespace clast {

namespace {

/// Where a point lies along a direction, 0 to 1 over the extent of the mesh.
std::function<double(const Vec3&)> place_along(const TriangleMesh& mesh, const Vec3& direction) {
  double low = 1e300, high = -1e300;
  for (const Vec3& v : mesh.vertices) {
    low = std::min(low, direction.dot(v));
    high = std::max(high, direction.dot(v));
  }
  return
      [=](const Vec3& p) { return std::clamp((direction.dot(p) - low) / (high - low), 0.0, 1.0); };
}

}  // namespace

std::vector<Vec3> sampled_cloud(const TriangleMesh& mesh, const CloudSample& sample,
                                Random& random) {
  const SurfaceSampler surface(mesh);
  std::vector<Vec3> points;
  while (points.size() < sample.points) {
    const Vec3 p = surface.draw(random).point;
    if (random.uniform() >= sample.density(p)) continue;
    const double x = random.normal(), y = random.normal(), z = random.normal();
    points.push_back(p + sample.noise * Vec3(x, y, z));
  }
  const Bounds box = bounds(mesh);
  const Vec3 sides = 1.5 * (box.high - box.low), low = 0.5 * (box.low + box.high) - 0.5 * sides;
  const auto strays = static_cast<std::size_t>(sample.outliers * double(sample.points));
  for (std::size_t i = 0; i < strays; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back(low + Vec3(x, y, z).cwiseProduct(sides));
  }
  return points;
}

std::function<double(const Vec3&)> falling_density(const TriangleMesh& mesh, const Vec3& direction,
                                                   double least) {
  return [place = place_along(mesh, direction), least](const Vec3& p) {
    return 1.0 - (1.0 - least) * place(p);
  };
}

std::function<double(const Vec3&)> halved_density(const TriangleMesh& mesh, const Vec3& direction,
                                                  double least) {
  return [place = place_along(mesh, direction), least](const Vec3& p) {
    return place(p) > 0.5 ? least : 1.0;
  };
}

}  // namespace clast
