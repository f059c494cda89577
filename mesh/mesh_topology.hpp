#pragma once
/// Topology of a mesh: tests if it is closed, manifold and oriented; components and boundary loops.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Counts of mesh elements, and of defects that prevent the mesh from bounding a single solid.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;        ///< edges with one triangle
  std::size_t non_manifold_edges = 0;    ///< edges with three or more triangles
  std::size_t boundary_loops = 0;        ///< closed loops of boundary edges (holes)
  std::size_t misoriented_edges = 0;     ///< edges whose two triangles have opposite windings
  std::size_t pinched_vertices = 0;      ///< vertices with more than one fan of triangles
  std::size_t degenerate_triangles = 0;  ///< triangles with a repeated vertex or zero area
  std::size_t components = 0;            ///< number of components connected over edges
  long euler_characteristic = 0;         ///< V - E + F, counting used vertices; 2 for a sphere

  bool is_closed() const { return triangles > 0 && boundary_edges == 0 && non_manifold_edges == 0; }
  bool is_oriented() const { return misoriented_edges == 0; }
  /// Describes the mesh: "closed", or "3 boundary edges in 1 loop, 2 non-manifold edges".
  std::string summary() const;
};

/// Counts elements and defects of a mesh. Triangles with a repeated vertex only count as
/// degenerate.
/// @throws GeometryError  if a triangle has an invalid vertex index
MeshReport inspect_mesh(const TriangleMesh& mesh);

/// Returns the component of each triangle. Components are connected over shared edges and numbered
/// in the order of their first triangles.
std::vector<std::uint32_t> triangle_components(const TriangleMesh& mesh);

/// Returns the boundary loops as vertex indices, in the direction that triangles filling the hole
/// need. Loops that touch at a vertex are separated there.
std::vector<std::vector<std::uint32_t>> boundary_loops(const TriangleMesh& mesh);

}  // namespace clast
