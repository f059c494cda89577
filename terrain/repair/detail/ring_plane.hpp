#pragma once
/// Plane fitted to the neighbours of a vertex.
#include <optional>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// Least-squares plane through the neighbours of a vertex: z = height + slope . (x, y), with x and
/// y relative to the vertex.
struct NeighbourPlane {
  double height = 0.0;  ///< at the vertex, m
  Vec2 slope = Vec2::Zero();
  double distance = 0.0;  ///< mean horizontal distance of the neighbours, m

  double height_at(const Vec2& from_vertex) const { return height + slope.dot(from_vertex); }
};

/// Fits a plane to the neighbours of a vertex; empty if there are fewer than three or if they are
/// collinear.
/// @param ring  neighbours, without the vertex itself
std::optional<NeighbourPlane> fit_neighbour_plane(const TriangleMesh& mesh,
                                                  std::span<const std::uint32_t> ring,
                                                  std::uint32_t vertex);

}  // namespace clast::terrain_detail
