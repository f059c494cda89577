#pragma once
/// Smallest bounding boxes of a convex hull for given directions, with the Gauss image of the hull.
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Smallest box with one given side direction.
struct BoxCandidate {
  double volume = std::numeric_limits<double>::infinity();  ///< m^3
  Mat3 axes = Mat3::Identity();                             ///< columns: unit directions
};

/// Convex hull with its Gauss image, in which faces are points on the unit sphere and edges arcs.
class GaussImage {
 public:
  /// Builds the Gauss image.
  /// @param mesh  convex hull, closed, outward
  /// @param radius  radius of the rounding, m
  GaussImage(const TriangleMesh& mesh, double radius);

  std::size_t face_count() const { return static_cast<std::size_t>(areas_.size()); }
  std::size_t edge_count() const { return edges_.size(); }
  Vec3 normal(std::size_t face) const { return normals_.row(static_cast<Eigen::Index>(face)); }
  double face_area(std::size_t face) const { return areas_[static_cast<Eigen::Index>(face)]; }
  std::array<std::size_t, 2> edge_faces(std::size_t edge) const {
    return {edges_[edge].face, edges_[edge].other_face};
  }
  double arc_length(std::size_t edge) const;  ///< angle between the face normals at an edge, rad
  /// Returns the direction at a fraction (0 to 1) of an edge's arc.
  Vec3 point_on_arc(std::size_t edge, double fraction) const;

  /// Returns the smallest box with one side along `direction`. If a lower bound of its volume
  /// exceeds `limit`, the search is skipped and the returned volume is infinite.
  /// @param direction  unit vector
  /// @param limit  largest volume of interest, m^3
  BoxCandidate smallest_box_along(const Vec3& direction, double limit);

 private:
  struct Edge {
    std::uint32_t from, to;  ///< counter-clockwise around `face`, seen from outside
    std::uint32_t face, other_face;
  };

  /// Traces the outline of the projection along the direction: the boundary of faces with `up_`.
  void trace_outline(const Mat3& frame);

  std::vector<Vec3> vertices_;
  std::vector<Edge> edges_;
  double radius_;
  Eigen::MatrixX3d coordinates_, normals_, weighted_normals_;  ///< the last by area
  Eigen::VectorXd areas_, along_, slopes_;
  std::vector<std::uint8_t> up_;     ///< per face: true if it faces along the direction
  std::vector<std::uint32_t> next_;  ///< per vertex of the outline: the next vertex
  std::vector<Vec2> outline_;
};

}  // namespace clast
