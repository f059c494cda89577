#pragma once
/// What a mesh is as a surface: closed, manifold, oriented, in how many components.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Counts of everything that keeps a mesh from bounding one solid.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;        ///< used by one triangle
  std::size_t non_manifold_edges = 0;    ///< used by three or more
  std::size_t boundary_loops = 0;        ///< closed runs of boundary edges: the holes
  std::size_t misoriented_edges = 0;     ///< both triangles run along it in the same direction
  std::size_t pinched_vertices = 0;      ///< their triangles form more than one fan
  std::size_t degenerate_triangles = 0;  ///< a repeated vertex, or no area
  std::size_t components = 0;            ///< connected over edges
  long euler_characteristic = 0;         ///< V - E + F over used vertices; 2 for a sphere

  bool is_closed() const { return triangles > 0 && boundary_edges == 0 && non_manifold_edges == 0; }
  bool is_oriented() const { return misoriented_edges == 0; }
  /// "closed" or the defects in words: "3 boundary edges in 1 loop, 2 non-manifold edges".
  std::string summary() const;
};

/// Triangles with a repeated vertex count as degenerate and take no part in the rest.
/// @throws GeometryError  a triangle names a vertex that isn't there
MeshReport inspect_mesh(const TriangleMesh& mesh);

/// Component number of every triangle, connected over shared edges; numbered by first triangle.
std::vector<std::uint32_t> triangle_components(const TriangleMesh& mesh);

/// Closed runs of boundary edges, each as vertex indices in the direction that a filling triangle
/// needs. A vertex where two loops touch splits them.
std::vector<std::vector<std::uint32_t>> boundary_loops(const TriangleMesh& mesh);

}  // namespace clast
