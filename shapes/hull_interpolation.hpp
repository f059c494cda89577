#pragma once
/// Interpolation between a star-shaped surface and its convex hull.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Moves vertices along their rays from the star's centre towards the hull. When all are on the
/// hull, the edges still below it are flipped one by one. Seen from the centre, the triangles
/// always cover each direction once. Therefore no intermediate surface intersects itself.
class HullInterpolation {
 public:
  /// Prepares the interpolation of a surface.
  /// @param surface  closed, outward
  /// @throws GeometryError  if the surface is not star-shaped
  explicit HullInterpolation(const TriangleMesh& surface);

  std::size_t edge_flips() const { return edge_flips_.size(); }
  /// Returns a surface between the given one and its hull.
  /// @param fraction  0 for the surface itself, 1 for all vertices on the hull
  /// @param edge_flips  number of flipped edges, at most `edge_flips()`
  TriangleMesh interpolate(double fraction, std::size_t edge_flips) const;
  double hull_volume() const { return hull_volume_; }  ///< m^3

 private:
  /// Two adjacent triangles and the two triangles that replace them.
  struct EdgeFlip {
    std::uint32_t first, second;
    TriangleMesh::Triangle new_first, new_second;
  };
  void find_edge_flips();
  bool flip_edge(TriangleMesh& mesh, std::uint32_t first, std::uint32_t second,
                 const std::array<std::uint32_t, 2>& edge);

  TriangleMesh surface_;
  Vec3 centre_ = Vec3::Zero();
  std::vector<double> hull_distance_;  ///< per vertex: distance of the hull over its own
  std::vector<EdgeFlip> edge_flips_;
  double hull_volume_ = 0.0;
};

}  // namespace clast
