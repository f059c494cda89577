#include "dem/surface/block_surface.hpp"

#include <algorithm>

#include "dem/surface/ghost_edges.hpp"

namespace clast::dem_detail {

EdgeNormalArc::EdgeNormalArc(const SurfaceFeatures& surface, const SurfaceEdge& edge)
    : slack(normal_arc_slack(surface, edge)), is_unbounded(edge.faces[1] == kNoFeature) {
  if (is_unbounded) return;
  first = surface.faces[edge.faces[0]].normal;
  second = surface.faces[edge.faces[1]].normal;
}

BlockSurface::BlockSurface(const SpheroPolyhedron& body)
    : IndexedSurface(build_indexed_surface(body)),
      parts(partition_block(features)),
      groups(find_feature_groups(features)) {
  for (std::uint32_t f = 0; f < features.faces.size(); ++f) {
    local_faces.push_back(make_local_face(features, f));
  }
  for (const SurfaceEdge& edge : features.edges) edge_normal_arcs.emplace_back(features, edge);
  for (std::uint32_t v = 0; v < features.vertices.size(); ++v) {
    cone_slacks.push_back(normal_cone_slack(features, v));
    bounding_radius = std::max(bounding_radius, features.vertices[v].norm());
  }
  bounding_radius += radius;
}

}  // namespace clast::dem_detail
