#pragma once
/// Normal cones of polyhedron vertices.
#include <span>

#include "core/types.hpp"

namespace clast::massprops_detail {

/// Integrals over the part of the unit sphere inside the normal cone of a vertex.
struct NormalConeIntegrals {
  double solid_angle = 0.0;    ///< integral of 1
  Vec3 first = Vec3::Zero();   ///< integral of the unit vector u
  Mat3 second = Mat3::Zero();  ///< integral of u u^T
};

/// Computes the integrals over the normal cone of a vertex: all unit vectors u with u . e <= 0 for
/// each edge direction e. All are zero if the polyhedron surrounds the vertex (a notch).
/// @param edges  unit directions of the edges leaving the vertex
/// @param exterior_angles  exterior dihedral angle of each edge, > 0 if convex; they distinguish a
///                         peak from a notch
NormalConeIntegrals integrate_normal_cone(std::span<const Vec3> edges,
                                          std::span<const double> exterior_angles);

}  // namespace clast::massprops_detail
