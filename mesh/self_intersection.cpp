#include "mesh/self_intersection.hpp"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <utility>

#include "mesh/detail/cgal_mesh.hpp"

namespace clast {

std::vector<std::array<std::uint32_t, 2>> find_self_intersections(const TriangleMesh& mesh) {
  const mesh_detail::CgalMesh surface = mesh_detail::to_cgal_mesh(mesh);
  std::vector<mesh_detail::CgalMesh::Face_index> with_area;
  for (const mesh_detail::CgalMesh::Face_index face : surface.faces()) {
    const auto& [a, b, c] = mesh.triangles[face.idx()];
    const auto point = [&](std::uint32_t v) {
      return surface.point(mesh_detail::CgalMesh::Vertex_index(v));
    };
    if (!CGAL::collinear(point(a), point(b), point(c))) with_area.push_back(face);
  }
  std::vector<std::pair<mesh_detail::CgalMesh::Face_index, mesh_detail::CgalMesh::Face_index>>
      found;
  CGAL::Polygon_mesh_processing::self_intersections(with_area, surface, std::back_inserter(found));
  std::vector<std::array<std::uint32_t, 2>> pairs;
  pairs.reserve(found.size());
  for (const auto& [first, second] : found) {
    pairs.push_back({std::min(first.idx(), second.idx()), std::max(first.idx(), second.idx())});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace clast
