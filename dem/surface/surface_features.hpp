#pragma once
/// Faces, edges and vertices of a triangulated surface with precomputed contact data. The same type
/// serves ground and blocks.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/segment_distance.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::dem_detail {

inline constexpr std::uint32_t kNoFeature = 0xffffffffu;

enum class EdgeKind : std::uint8_t {
  kFlat,    ///< between coplanar faces; never a contact feature
  kConvex,  ///< between faces that meet at a convex angle
  kReflex,  ///< between faces that meet at a concave angle; other bodies reach the faces first
  kBorder,  ///< border edge with one face
  kWire,    ///< without faces: axis of a capsule
};

struct SurfaceFace {
  std::array<std::uint32_t, 3> vertices;
  std::array<std::uint32_t, 3> edges;  ///< edges; edge k runs from vertex k to vertex k + 1
  Vec3 normal;                         ///< unit, out of the solid
};

struct SurfaceEdge {
  std::array<std::uint32_t, 2> vertices;
  /// Adjacent faces; the second is kNoFeature at a border, both for a wire.
  std::array<std::uint32_t, 2> faces;
  Vec3 direction;  ///< unit, from the first vertex to the second
  double length = 0.0;
  EdgeKind kind = EdgeKind::kFlat;
  /// True for each face that has the edge in its direction.
  std::array<bool, 2> forward = {true, false};

  bool is_convex() const { return kind != EdgeKind::kFlat && kind != EdgeKind::kReflex; }
};

/// Faces, edges and vertices of a surface.
struct SurfaceFeatures {
  std::vector<Vec3> vertices;
  std::vector<SurfaceFace> faces;
  std::vector<SurfaceEdge> edges;
  /// Angle-weighted unit normals of the vertices (Baerentzen & Aanaes 2005).
  std::vector<Vec3> vertex_normals;
  /// True for vertices that can be in contact: ends of convex edges without collinear continuation.
  std::vector<std::uint8_t> is_pointed_vertex;
  /// Index in `edges_at_vertex` of the first edge of each vertex.
  std::vector<std::uint32_t> edge_offsets;
  /// Edges of all vertices, ordered by vertex and sorted for each vertex.
  std::vector<std::uint32_t> edges_at_vertex;

  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const {
    return {edges_at_vertex.data() + edge_offsets[vertex],
            edges_at_vertex.data() + edge_offsets[vertex + 1]};
  }
  /// Returns the unit direction of an edge away from one of its vertices.
  Vec3 edge_direction_from(std::uint32_t edge, std::uint32_t vertex) const {
    const SurfaceEdge& e = edges[edge];
    return e.vertices[0] == vertex ? e.direction : Vec3(-e.direction);
  }
  Segment segment(const SurfaceEdge& edge) const {
    return {vertices[edge.vertices[0]], edge.direction, edge.length};
  }
  /// Returns the unit mean of the face normals at an edge; arbitrary for a wire.
  Vec3 edge_normal(const SurfaceEdge& edge) const;
};

/// Extracts faces, edges and vertices of a mesh, with their contact data.
/// @param wires  edges without triangles (capsules), as vertex pairs
/// @throws GeometryError  if a triangle is degenerate or an edge non-manifold
SurfaceFeatures extract_surface_features(const TriangleMesh& mesh,
                                         std::span<const std::array<std::uint32_t, 2>> wires = {});

/// Returns the distance from the projection of a point to the border of the face that contains it,
/// m; -1 if it is outside the face.
double distance_inside_face(const SurfaceFeatures& surface, const SurfaceFace& face,
                            const Vec3& point);

/// Returns the direction in the plane of a face, perpendicular to its edge and pointing into the
/// face; unit if `edge_direction` is.
/// @param forward  true if the face runs in the direction of the edge, `SurfaceEdge::forward`
inline Vec3 inward_direction(const SurfaceFace& face, const Vec3& edge_direction, bool forward) {
  return forward ? face.normal.cross(edge_direction) : edge_direction.cross(face.normal);
}

/// True if two edges that leave a vertex in these directions are collinear.
bool are_collinear(const Vec3& first_ray, const Vec3& second_ray);

}  // namespace clast::dem_detail
