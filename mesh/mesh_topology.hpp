#pragma once
/// Topology of a mesh: closed, manifold, oriented, components.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Defects that prevent a mesh from bounding a single solid.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;        ///< edges of one triangle
  std::size_t non_manifold_edges = 0;    ///< edges of three or more triangles
  std::size_t boundary_loops = 0;        ///< closed boundary loops: holes
  std::size_t misoriented_edges = 0;     ///< edges whose two triangles have opposite windings
  std::size_t pinched_vertices = 0;      ///< vertices with more than one fan of triangles
  std::size_t degenerate_triangles = 0;  ///< repeated vertex or zero area
  std::size_t components = 0;            ///< connected over edges
  long euler_characteristic = 0;         ///< V - E + F over used vertices; 2 for a sphere

  bool is_closed() const { return triangles > 0 && boundary_edges == 0 && non_manifold_edges == 0; }
  bool is_oriented() const { return misoriented_edges == 0; }
  /// Describes the mesh: "closed", or "3 boundary edges in 1 loop, 2 non-manifold edges".
  std::string summary() const;
};

/// Counts the defects. Triangles with a repeated vertex are counted as degenerate and otherwise
/// ignored.
/// @throws GeometryError  if a triangle has an invalid vertex index
MeshReport inspect_mesh(const TriangleMesh& mesh);

/// Returns the component of each triangle, connected over shared edges, numbered by first triangle.
std::vector<std::uint32_t> triangle_components(const TriangleMesh& mesh);

/// Returns the boundary loops as vertex indices, in the direction that filling triangles need.
/// Loops are split at vertices where two of them touch.
std::vector<std::vector<std::uint32_t>> boundary_loops(const TriangleMesh& mesh);

}  // namespace clast
