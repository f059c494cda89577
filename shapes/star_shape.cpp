#include "shapes/star_shape.hpp"

#include <algorithm>

#include "mesh/triangle_geometry.hpp"
#include "shapes/convex_cell.hpp"

namespace clast {
namespace {

/// Fraction of the diagonal within which kernel vertices lie on a plane.
constexpr double kKernelSlack = 1e-9;
/// Fraction of the diagonal below a plane, within which a point sees the triangle edge-on.
constexpr double kMinDepth = 1e-5;

}  // namespace

std::optional<Vec3> find_kernel_centroid(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  const Vec3 origin = 0.5 * (box.low + box.high);
  const double diagonal = box.diagonal();
  Bounds local;
  local.include(box.low - origin);
  local.include(box.high - origin);
  std::vector<Plane> planes;
  std::optional<ConvexCell> kernel = ConvexCell(local);
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    const Vec3 normal = unit_normal(mesh, triangle);
    if (normal.isZero()) continue;
    planes.push_back({normal, normal.dot(mesh.vertices[triangle[0]] - origin)});
    kernel = kernel->clipped_below(planes.back(), kKernelSlack * diagonal);
    if (!kernel) return std::nullopt;
  }
  const Vec3 centre = kernel->centre();
  const bool inside = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return plane.signed_distance(centre) < -kMinDepth * diagonal;
  });
  return inside ? std::optional<Vec3>(origin + centre) : std::nullopt;
}

}  // namespace clast
