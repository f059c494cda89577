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
  kRidge,   ///< convex: the solid falls away on both sides
  kValley,  ///< reflex: nothing can reach it before its faces
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
  std::array<bool, 2> along = {true, false};  ///< either face runs from the first vertex to the
                                              ///< second

  bool convex() const { return kind != EdgeKind::kFlat && kind != EdgeKind::kValley; }
};

/// A whole surface. To keep large terrains small, what follows from these in a few operations is
/// computed when it is needed.
struct SurfaceFeatures {
  std::vector<Vec3> vertices;
  std::vector<SurfaceFace> faces;
  std::vector<SurfaceEdge> edges;
  std::vector<Vec3> vertex_normals;   ///< angle-weighted, unit (Baerentzen & Aanaes 2005)
  std::vector<std::uint8_t> pointed;  ///< vertices that can be touched: a convex edge ends
                                      ///< there and does not go straight on
  std::vector<std::uint32_t>
      edge_offsets;  ///< edges at vertex v: edges_at_vertex[edge_offsets[v] ..]
  std::vector<std::uint32_t> edges_at_vertex;  ///< sorted

  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const {
    return {edges_at_vertex.data() + edge_offsets[vertex],
            edges_at_vertex.data() + edge_offsets[vertex + 1]};
  }
  /// Unit direction in which an edge leaves one of its vertices.
  Vec3 ray(std::uint32_t edge, std::uint32_t vertex) const {
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
SurfaceFeatures surface_features(const TriangleMesh& mesh,
                                 std::span<const std::array<std::uint32_t, 2>> wires = {});

/// How far inside the face the foot of the point on its plane lies, m; -1 when outside.
double depth_in_face(const SurfaceFeatures& surface, const SurfaceFace& face, const Vec3& point);

/// True when `direction` points out of the solid at the edge: within the arc between the normals
/// of its faces (to 1e-9).
bool in_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge, const Vec3& direction);
/// The same, and beyond it 3 degrees where the edge's faces stand at a right angle and nothing
/// where they are smooth. Where a flat face of one body lies partly over another, the edges that
/// bound the overlap then carry their share whichever way the two are tilted a little.
bool near_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge, const Vec3& direction);

/// How far beyond the arc or the cone `near_arc` and `near_cone` go, a sine.
double arc_slack(const SurfaceFeatures& surface, const SurfaceEdge& edge);
double cone_slack(const SurfaceFeatures& surface, std::uint32_t vertex);

/// True when no edge leaving the vertex rises along `direction`, and it points out of the solid: it
/// lies in the normal cone.
bool in_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);
/// The same with such a slack, from the largest angle between the vertex's faces and its normal.
bool near_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);

/// True when two edges that leave a vertex along these rays go straight on into each other.
bool straight_on(const Vec3& first_ray, const Vec3& second_ray);

}  // namespace clast::dem_detail
