#pragma once
/// CGAL kernel and surface mesh, and conversion from and to `TriangleMesh`.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>

#include "core/error.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::mesh_detail {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = CgalKernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

/// Converts a triangle mesh to a CGAL mesh.
/// @throws GeometryError  if an edge is non-manifold or the windings are inconsistent
inline CgalMesh to_cgal_mesh(const TriangleMesh& mesh) {
  CgalMesh result;
  result.reserve(static_cast<CgalMesh::size_type>(mesh.vertices.size()),
                 static_cast<CgalMesh::size_type>(3 * mesh.triangles.size() / 2),
                 static_cast<CgalMesh::size_type>(mesh.triangles.size()));
  for (const Vec3& v : mesh.vertices) result.add_vertex(CgalPoint(v.x(), v.y(), v.z()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto face = result.add_face(CgalMesh::Vertex_index(a), CgalMesh::Vertex_index(b),
                                      CgalMesh::Vertex_index(c));
    if (face == CgalMesh::null_face()) {
      throw GeometryError("triangle " + std::to_string(t + 1) +
                          " does not fit its neighbours: the surface is not a 2-manifold");
    }
  }
  return result;
}

/// Converts a CGAL mesh to a triangle mesh. The order is kept; removed elements are skipped.
inline TriangleMesh from_cgal_mesh(const CgalMesh& mesh) {
  TriangleMesh result;
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const CgalMesh::Vertex_index v : mesh.vertices()) {
    number[v.idx()] = static_cast<std::uint32_t>(result.vertices.size());
    const CgalPoint& p = mesh.point(v);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const CgalMesh::Face_index f : mesh.faces()) {
    TriangleMesh::Triangle triangle{};
    std::size_t corner = 0;
    for (const CgalMesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      triangle[corner++] = number[v.idx()];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace clast::mesh_detail
