#pragma once
/// The plane that the ground around a vertex lies in.
#include <optional>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// The plane z = height + slope . (x, y) about a vertex, by least squares through its neighbours.
struct RingPlane {
  double height = 0.0;  ///< at the vertex, m
  Vec2 slope = Vec2::Zero();
  double distance = 0.0;  ///< of the neighbours in plan, mean, m

  double height_at(const Vec2& from_vertex) const { return height + slope.dot(from_vertex); }
};

/// None with fewer than three neighbours, or where they are in line.
/// @param ring  the neighbours; the vertex itself does not count
std::optional<RingPlane> fit_ring_plane(const TriangleMesh& mesh,
                                        std::span<const std::uint32_t> ring, std::uint32_t vertex);

}  // namespace clast::terrain_detail
