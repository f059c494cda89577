#include "mesh/surface_samples.hpp"

#include <cmath>

#include "core/random.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast {

namespace {

constexpr std::uint64_t kSeed = 20220906;  ///< any fixed number: same shapes, same samples

}  // namespace

std::vector<Vec3> sample_surface(const TriangleMesh& mesh, std::size_t count) {
  std::vector<double> doubled_areas;
  double total = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    doubled_areas.push_back(doubled_area_vector(mesh, t).norm());
    total += doubled_areas.back();
  }
  Random random(kSeed);
  std::vector<Vec3> points;
  double passed = 0.0;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted =
        total * (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    while (triangle + 1 < doubled_areas.size() && passed + doubled_areas[triangle] < wanted) {
      passed += doubled_areas[triangle++];
    }
    const double root = std::sqrt(random.uniform()), along = random.uniform();
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    points.push_back((1.0 - root) * mesh.vertices[t[0]] +
                     root * (1.0 - along) * mesh.vertices[t[1]] +
                     root * along * mesh.vertices[t[2]]);
  }
  return points;
}

}  // namespace clast
