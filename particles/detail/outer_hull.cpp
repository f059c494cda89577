#include "particles/detail/outer_hull.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "shapes/convex_hull.hpp"

namespace clast::particles_detail {

namespace {

/// Distance from a plane, relative to the size of the cell, within which a vertex is on it.
constexpr double kOnPlane = 1e-12;

double highest(const Vec3& normal, const std::vector<Vec3>& points) {
  double height = -std::numeric_limits<double>::infinity();
  for (const Vec3& point : points) height = std::max(height, normal.dot(point));
  return height;
}

}  // namespace

TriangleMesh outer_hull(const TriangleMesh& hull, std::span<const Plane> planes, ConvexCell cell,
                        std::size_t max_vertices) {
  const double tolerance = kOnPlane * cell.box().diagonal();
  std::vector<Plane> open;
  for (const Plane& plane : planes) {
    // The whole hull is below the plane, to the last bit.
    open.push_back({plane.normal, highest(plane.normal, hull.vertices)});
  }
  while (!open.empty()) {
    std::size_t best = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const double above = highest(open[i].normal, cell.vertices()) - open[i].distance;
      if (above > most) most = above, best = i;
    }
    if (most <= tolerance) break;
    std::optional<ConvexCell> cut = cell.clipped_below(open[best], tolerance);
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(best));
    if (cut && cut->vertices().size() <= max_vertices) cell = std::move(*cut);
  }
  return convex_hull(cell.vertices());
}

}  // namespace clast::particles_detail
