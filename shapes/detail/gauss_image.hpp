#pragma once
/// Boxes around a convex hull about directions of its Gauss image.
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// A direction seen as the normal of one pair of box sides, with the best box it allows.
struct BoxCandidate {
  double volume = std::numeric_limits<double>::infinity();  ///< m^3
  Mat3 axes = Mat3::Identity();                             ///< columns: unit directions
};

/// The hull with its Gauss image: faces are points on the sphere of directions, edges are arcs.
class GaussImage {
 public:
  /// @param mesh    a convex hull, closed, outward
  /// @param radius  of the ball that sweeps it, m
  GaussImage(const TriangleMesh& mesh, double radius);

  std::size_t face_count() const { return static_cast<std::size_t>(areas_.size()); }
  std::size_t edge_count() const { return edges_.size(); }
  Vec3 normal(std::size_t face) const { return normals_.row(static_cast<Eigen::Index>(face)); }
  double face_area(std::size_t face) const { return areas_[static_cast<Eigen::Index>(face)]; }
  std::array<std::size_t, 2> edge_faces(std::size_t edge) const {
    return {edges_[edge].face, edges_[edge].other_face};
  }
  double arc_length(std::size_t edge) const;  ///< between the normals at an edge, rad
  /// At `fraction` of the way along the arc of an edge.
  Vec3 point_on_arc(std::size_t edge, double fraction) const;

  /// The smallest box with sides along and across `direction`, with infinite volume where a lower
  /// bound (projected area times width) says that it is above `limit`.
  /// @param direction  unit
  /// @param limit      m^3
  BoxCandidate best_box_about(const Vec3& direction, double limit);

 private:
  struct Edge {
    std::uint32_t from, to;  ///< counter-clockwise around `face`, seen from outside
    std::uint32_t face, other_face;
  };

  /// Corners of the shadow's outline: faces that look up are bounded by one loop of edges, which
  /// runs around the shadow.
  void trace_outline(const Mat3& frame);

  std::vector<Vec3> vertices_;
  std::vector<Edge> edges_;
  double radius_;
  Eigen::MatrixX3d coordinates_, normals_, weighted_normals_;  ///< the last ones by area
  Eigen::VectorXd areas_, along_, slopes_;
  std::vector<std::uint8_t> up_;     ///< of every face: looks along the direction
  std::vector<std::uint32_t> next_;  ///< of vertices on the outline
  std::vector<Vec2> outline_;
};

}  // namespace clast
