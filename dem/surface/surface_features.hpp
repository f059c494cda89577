#pragma once
/// Faces, edges and vertices of a triangulated surface with everything that the contact rules need
/// of them. The ground and the blocks are described by the same structure.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/segment_distance.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::dem_detail {

inline constexpr std::uint32_t kNoFeature = 0xffffffffu;

enum class EdgeKind : std::uint8_t {
  kFlat,    ///< both faces in one plane: never in contact by itself
  kConvex,  ///< convex: the solid falls away on both sides
  kReflex,  ///< reflex: nothing can reach it before its faces
  kBorder,  ///< one face only
  kWire,    ///< no face: an edge of a capsule
};

struct SurfaceFace {
  std::array<std::uint32_t, 3> vertices;
  std::array<std::uint32_t, 3> edges;  ///< edge k runs from vertex k to vertex k + 1
  Vec3 normal;                         ///< unit, out of the solid
};

struct SurfaceEdge {
  std::array<std::uint32_t, 2> vertices;
  std::array<std::uint32_t, 2> faces;  ///< the second is kNoFeature for a border, both for a wire
  Vec3 direction;                      ///< unit, from the first vertex to the second
  double length = 0.0;
  EdgeKind kind = EdgeKind::kFlat;
  std::array<bool, 2> forward = {true, false};  ///< either face runs from the first vertex to the
                                                ///< second

  bool is_convex() const { return kind != EdgeKind::kFlat && kind != EdgeKind::kReflex; }
};

/// A whole surface. To keep large terrains small, what follows from these in a few operations is
/// computed when it is needed.
struct SurfaceFeatures {
  std::vector<Vec3> vertices;
  std::vector<SurfaceFace> faces;
  std::vector<SurfaceEdge> edges;
  std::vector<Vec3> vertex_normals;             ///< angle-weighted, unit (Baerentzen & Aanaes 2005)
  std::vector<std::uint8_t> is_pointed_vertex;  ///< vertices that can be touched: a convex edge
                                                ///< ends there and does not go straight on
  std::vector<std::uint32_t>
      edge_offsets;  ///< edges at vertex v: edges_at_vertex[edge_offsets[v] ..]
  std::vector<std::uint32_t> edges_at_vertex;  ///< sorted

  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const {
    return {edges_at_vertex.data() + edge_offsets[vertex],
            edges_at_vertex.data() + edge_offsets[vertex + 1]};
  }
  /// Unit direction in which an edge leaves one of its vertices.
  Vec3 edge_direction_from(std::uint32_t edge, std::uint32_t vertex) const {
    const SurfaceEdge& e = edges[edge];
    return e.vertices[0] == vertex ? e.direction : Vec3(-e.direction);
  }
  Segment segment(const SurfaceEdge& edge) const {
    return {vertices[edge.vertices[0]], edge.direction, edge.length};
  }
  /// Mean of the normals of the faces at an edge, unit; of a wire any.
  Vec3 edge_normal(const SurfaceEdge& edge) const;
};

/// @param wires  edges that belong to no triangle (capsules), as vertex pairs
/// @throws GeometryError  a triangle without area, or an edge with three or more triangles
SurfaceFeatures extract_surface_features(const TriangleMesh& mesh,
                                         std::span<const std::array<std::uint32_t, 2>> wires = {});

/// How far inside the face the foot of the point on its plane lies, m; -1 when outside.
double distance_inside_face(const SurfaceFeatures& surface, const SurfaceFace& face,
                            const Vec3& point);

/// The direction in the plane of a face that is perpendicular to its edge and points into the face;
/// unit if `edge_direction` is.
/// @param forward  true if the face runs along the direction of the edge, `SurfaceEdge::forward`
inline Vec3 inward_direction(const SurfaceFace& face, const Vec3& edge_direction, bool forward) {
  return forward ? face.normal.cross(edge_direction) : edge_direction.cross(face.normal);
}

/// True when two edges that leave a vertex along these rays go straight on into each other.
bool are_collinear(const Vec3& first_ray, const Vec3& second_ray);

}  // namespace clast::dem_detail
