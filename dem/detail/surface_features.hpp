#pragma once
/// Faces, edges and vertices of a triangulated surface with everything the contact rules ask of
/// them. The ground and the blocks are described by the same structure.
#include <cstdint>
#include <span>
#include <vector>

#include "shapes/triangle_mesh.hpp"

namespace clast {

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
  std::array<Vec3, 3> inward;          ///< in the plane, perpendicular to edge k, into the face
  Vec3 normal;                         ///< unit, out of the solid
  std::uint32_t plane = 0;             ///< faces joined over flat edges share this number
};

struct SurfaceEdge {
  std::array<std::uint32_t, 2> vertices;
  std::array<std::uint32_t, 2> faces;  ///< the second is kNoFeature for a border, both for a wire
  std::array<Vec3, 2> inward;          ///< into either face, perpendicular to the edge
  Vec3 direction;                      ///< unit, from the first vertex to the second
  Vec3 normal;                         ///< mean of the face normals, unit
  double length = 0.0;
  double give = 0.0;  ///< sine of how far beyond its arc flat bodies still rest on it
  EdgeKind kind = EdgeKind::kFlat;
  std::uint32_t line = 0;  ///< convex edges that go straight on into each other share this number

  bool convex() const { return kind != EdgeKind::kFlat && kind != EdgeKind::kValley; }
};

/// A whole surface.
struct SurfaceFeatures {
  std::vector<Vec3> vertices;
  std::vector<SurfaceFace> faces;
  std::vector<SurfaceEdge> edges;
  std::vector<Vec3> vertex_normals;          ///< angle-weighted, unit (Baerentzen & Aanaes 2005)
  std::vector<double> give;                  ///< of every vertex, like that of an edge
  std::vector<std::uint8_t> pointed;         ///< vertices that can be touched: a convex edge ends
                                             ///< there and does not go straight on
  std::vector<std::uint32_t> ray_offsets;    ///< edges leaving vertex v: rays[ray_offsets[v] ..]
  std::vector<Vec3> rays;                    ///< unit directions
  std::vector<std::uint32_t> joint_offsets;  ///< joints of vertex v: joints[joint_offsets[v] ..]
  std::vector<std::uint32_t> joints;         ///< planes and lines that meet there, sorted

  std::span<const Vec3> rays_of(std::uint32_t vertex) const {
    return {rays.data() + ray_offsets[vertex], rays.data() + ray_offsets[vertex + 1]};
  }
  std::span<const std::uint32_t> joints_of(std::uint32_t vertex) const {
    return {joints.data() + joint_offsets[vertex], joints.data() + joint_offsets[vertex + 1]};
  }
  /// Planes and lines in one numbering: a plane by its number, a line after all faces.
  std::uint32_t joint_of_line(std::uint32_t line) const {
    return static_cast<std::uint32_t>(faces.size()) + line;
  }
};

/// @param wires  edges that belong to no triangle (capsules), as vertex pairs
/// @throws GeometryError  a triangle without area, or an edge with three or more triangles
SurfaceFeatures surface_features(const TriangleMesh& mesh,
                                 std::span<const std::array<std::uint32_t, 2>> wires = {});

/// True when `direction` points out of the solid at the edge: within the arc between the normals
/// of its faces (to 1e-9).
bool in_arc(const SurfaceEdge& edge, const Vec3& direction);
/// The same with the edge's give: a thirtieth of the angle by which its faces turn, 3 degrees at a
/// right angle and nothing where they are smooth. Where two flat faces overlap partly, the edges
/// that bound the overlap then carry their share whichever way the faces are tilted a little.
bool near_arc(const SurfaceEdge& edge, const Vec3& direction);

/// True when no edge leaving the vertex rises along `direction`: it lies in the normal cone.
bool in_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);
/// The same with the vertex's give, from the largest angle between its faces and its normal.
bool near_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);

}  // namespace clast
