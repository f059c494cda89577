#pragma once
/// Which edges of a core stick out, lie flat or fold in.
#include <cstdint>
#include <vector>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

enum class EdgeConvexity : std::uint8_t {
  kFlat = 0,    ///< both faces in one plane: no edge of the body at all
  kConvex = 1,  ///< the solid falls away on both sides
  kReflex = 2,  ///< the solid rises: nothing flat reaches the edge before its faces
};

/// Sine of the angle between faces below which an edge is flat: single-precision files leave less
/// than this on a true plane of metre-sized triangles.
inline constexpr double kFlatSine = 1e-7;

/// Of an edge between two faces. A knife's edge, the faces back to back, is convex.
/// @param first, second  unit normals out of the solid
/// @param into_second    unit, in the plane of the second face, perpendicular to the edge
EdgeConvexity edge_convexity(const Vec3& first, const Vec3& second, const Vec3& into_second);

/// Of every edge of the shape, in their order. An edge without two faces that run along it in
/// opposite directions (a capsule's) is convex.
std::vector<EdgeConvexity> edge_convexities(const SpheroPolyhedron& shape);

}  // namespace clast
