#pragma once
/// Surfaces between a star-shaped one and its convex hull.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Every vertex moves along its ray from the star's centre towards the hull. Where all have
/// arrived, edges still lie below the hull; those are turned (each to the other diagonal of its two
/// triangles), one by one, until none is left. Triangles as seen from the centre cover the
/// directions once, whatever the distances of their corners, so no surface of these crosses itself.
class HullInterpolation {
 public:
  /// @param surface  closed, outward
  /// @throws GeometryError  the surface is not star-shaped
  explicit HullInterpolation(const TriangleMesh& surface);

  /// How many edges can be turned.
  std::size_t edge_flips() const { return edge_flips_.size(); }
  /// @param part   0: the surface itself; 1: all vertices on the hull
  /// @param turns  edges that are turned, at most `edge_flips()`
  TriangleMesh interpolate(double fraction, std::size_t edge_flips) const;
  double hull_volume() const { return hull_volume_; }  ///< m^3

 private:
  /// Two triangles that share an edge, and those over the other diagonal.
  struct EdgeFlip {
    std::uint32_t first, second;
    TriangleMesh::Triangle new_first, new_second;
  };
  void find_edge_flips();
  bool flip_edge(TriangleMesh& mesh, std::uint32_t first, std::uint32_t second,
                 const std::array<std::uint32_t, 2>& edge);

  TriangleMesh surface_;
  Vec3 centre_ = Vec3::Zero();
  std::vector<double> hull_distance_;  ///< of each vertex: distance of the hull over its own
  std::vector<EdgeFlip> edge_flips_;
  double hull_volume_ = 0.0;
};

}  // namespace clast
