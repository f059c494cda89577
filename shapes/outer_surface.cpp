#include "shapes/outer_surface.hpp"

#include <algorithm>

#include "mesh/alpha_wrap.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/edge_convexity.hpp"

namespace clast {

namespace {

/// Shortest triangles, as a share of the diagonal: about 1e5 of them on a block.
constexpr double kFinest = 1.0 / 150.0;

double piece_length(const SpheroPolyhedron& shape, int segments) {
  return 0.5 * kPi / segments * shape.radius;
}

double finest_length(const SpheroPolyhedron& shape) {
  Bounds box;
  for (const Vec3& vertex : shape.vertices) box.include(vertex);
  return kFinest * box.diagonal();
}

}  // namespace

std::optional<double> outer_surface_edge_length(const SpheroPolyhedron& shape, int segments) {
  const std::vector<EdgeConvexity> bends = edge_convexities(shape);
  const bool has_reflex =
      std::find(bends.begin(), bends.end(), EdgeConvexity::kReflex) != bends.end();
  if (!has_reflex || shape.radius == 0.0) return std::nullopt;
  return std::max(piece_length(shape, segments), finest_length(shape));
}

int max_outer_surface_segments(const SpheroPolyhedron& shape) {
  return std::max(1, static_cast<int>(std::ceil(piece_length(shape, 1) / finest_length(shape))));
}

TriangleMesh outer_surface_mesh(const SpheroPolyhedron& shape, int segments) {
  TriangleMesh crossing = rounded_surface_mesh(shape, segments);  // also refuses what has no skin
  const std::optional<double> length = outer_surface_edge_length(shape, segments);
  if (!length) return crossing;
  const TriangleMesh core = core_mesh(shape);
  TriangleMesh skin = alpha_wrap(core, *length, shape.radius);
  // The wrap finds the offset surface to a share of its distance only.
  const TriangleTree tree(core);
  for (Vec3& vertex : skin.vertices) {
    const Vec3 nearest = tree.closest_point(vertex).point;
    vertex = nearest + shape.radius * (vertex - nearest).normalized();
  }
  return skin;
}

}  // namespace clast
