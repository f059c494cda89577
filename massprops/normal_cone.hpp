#pragma once
/// The directions in which a vertex is the nearest point of a polyhedron.
#include <span>

#include "core/types.hpp"

namespace clast::massprops_detail {

/// Integrals over the part of the unit sphere in a cone.
struct NormalCone {
  double solid_angle = 0.0;    ///< integral of 1
  Vec3 first = Vec3::Zero();   ///< of u
  Mat3 second = Mat3::Zero();  ///< of u u^T
};

/// Cone of all u with u . e <= 0 for every edge direction e: polar to the polyhedron at the vertex.
/// Empty where the polyhedron surrounds the vertex (a notch).
/// @param edges  unit directions of the edges that leave the vertex
/// @param bends  exterior dihedral angle of each, > 0 convex; distinguishes a peak from a notch
NormalCone normal_cone(std::span<const Vec3> edges, std::span<const double> exterior_angles);

}  // namespace clast::massprops_detail
