#pragma once
/// Classification of core edges as convex, flat or reflex.
#include <cstdint>
#include <vector>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

enum class EdgeConvexity : std::uint8_t {
  kFlat = 0,    ///< both faces in one plane
  kConvex = 1,  ///< dihedral angle of the solid below 180 degrees
  kReflex = 2,  ///< dihedral angle of the solid above 180 degrees
};

/// Sine of the angle between face normals below which an edge is flat. It exceeds the rounding
/// error of single-precision files with metre-sized triangles.
inline constexpr double kFlatSine = 1e-7;

/// Classifies the edge between two faces. An edge between back-to-back faces is convex.
/// @param first, second  unit normals out of the solid
/// @param into_second  unit vector in the plane of the second face, perpendicular to the edge
EdgeConvexity edge_convexity(const Vec3& first, const Vec3& second, const Vec3& into_second);

/// Classifies all edges of a shape, in their order. Edges without two consistently oriented faces,
/// as in capsules, are convex.
std::vector<EdgeConvexity> edge_convexities(const SpheroPolyhedron& shape);

}  // namespace clast
