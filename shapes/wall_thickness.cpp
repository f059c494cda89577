#include "shapes/wall_thickness.hpp"

#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast {

namespace {

constexpr double kParallel = 0.8660254037844386;  ///< cosine of 30 degrees

}  // namespace

std::optional<ThinWall> find_thinnest_wall(const TriangleMesh& mesh) {
  std::optional<ThinWall> thinnest;
  if (mesh.triangles.empty()) return thinnest;
  const TriangleTree tree(mesh);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 inward = -unit_normal(mesh, mesh.triangles[t]);
    if (inward.isZero()) continue;
    const Vec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
    const auto hit = tree.first_exit(middle, inward, t);
    if (!hit || (thinnest && hit->distance >= thinnest->thickness)) continue;
    if (unit_normal(mesh, mesh.triangles[hit->triangle]).dot(inward) < kParallel) continue;
    thinnest = ThinWall{hit->distance, middle + 0.5 * hit->distance * inward};
  }
  return thinnest;
}

}  // namespace clast
