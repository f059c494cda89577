#pragma once
/// Normal cones of polyhedron vertices.
#include <span>

#include "core/types.hpp"

namespace clast::massprops_detail {

/// Integrals over the part of the unit sphere in a cone.
struct NormalCone {
  double solid_angle = 0.0;    ///< integral of 1
  Vec3 first = Vec3::Zero();   ///< of u
  Mat3 second = Mat3::Zero();  ///< of u u^T
};

/// Computes the cone of all u with u . e <= 0 for each edge direction e, polar to the polyhedron at
/// the vertex. Empty if the polyhedron surrounds the vertex (a notch).
/// @param edges  unit directions of the edges leaving the vertex
/// @param exterior_angles  exterior dihedral angle of each, > 0 for convex; distinguishes a peak
///                         from a notch
NormalCone normal_cone(std::span<const Vec3> edges, std::span<const double> exterior_angles);

}  // namespace clast::massprops_detail
