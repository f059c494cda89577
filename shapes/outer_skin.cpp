#include "shapes/outer_skin.hpp"

#include <CGAL/alpha_wrap_3.h>

#include <algorithm>

#include "shapes/detail/cgal_mesh.hpp"
#include "shapes/detail/triangle_tree.hpp"
#include "shapes/edge_bend.hpp"

namespace clast {

namespace {

/// Shortest triangles, as a share of the diagonal: about 1e5 of them on a block.
constexpr double kFinest = 1.0 / 150.0;

}  // namespace

TriangleMesh outer_skin(const SpheroPolyhedron& shape, int segments) {
  const std::vector<EdgeBend> bends = edge_bends(shape);
  const bool has_reflex = std::find(bends.begin(), bends.end(), EdgeBend::kReflex) != bends.end();
  TriangleMesh crossing = skin_mesh(shape, segments);  // also refuses what has no skin
  if (!has_reflex || shape.radius == 0.0) return crossing;
  const TriangleMesh core = core_mesh(shape);
  const double piece = 0.5 * kPi / segments * shape.radius;
  detail::CgalMesh wrap;
  CGAL::alpha_wrap_3(detail::to_cgal(core), std::max(piece, kFinest * bounds(core).diagonal()),
                     shape.radius, wrap);
  TriangleMesh skin = detail::from_cgal(wrap);
  // The wrap finds the offset surface to a share of its distance only.
  const detail::TriangleTree tree(core);
  for (Vec3& vertex : skin.vertices) {
    const Vec3 nearest = tree.closest(vertex).point;
    vertex = nearest + shape.radius * (vertex - nearest).normalized();
  }
  return skin;
}

}  // namespace clast
