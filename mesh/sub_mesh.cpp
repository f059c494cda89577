#include "mesh/sub_mesh.hpp"

#include <cstdint>

#include "core/types.hpp"

namespace clast {

namespace {}  // namespace

TriangleMesh extract_triangles(const TriangleMesh& source,
                               const std::vector<TriangleMesh::Triangle>& triangles) {
  TriangleMesh result{source.vertices, triangles};
  remove_unused_vertices(result);
  return result;
}

TriangleMesh extract_triangles(const TriangleMesh& mesh, const std::vector<bool>& keep) {
  std::vector<TriangleMesh::Triangle> kept;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (keep[t]) kept.push_back(mesh.triangles[t]);
  }
  return extract_triangles(mesh, kept);
}

void remove_unused_vertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNoIndex);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) number[corner] = 0;
  }
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    mesh.vertices[count] = mesh.vertices[v];
    number[v] = count++;
  }
  mesh.vertices.resize(count);
  for (TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = number[corner];
  }
}

}  // namespace clast
