#pragma once
/// The ground near a part of a block, copied together so that many queries read little memory.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/detail/indexed_surface.hpp"

namespace clast {

/// A plane that no ground of some region rises above: bounds the distance to all of it at once.
struct GroundPlane {
  Vec3 normal = Vec3::UnitZ();  ///< mean of the faces' normals
  double top = -1e300;          ///< largest normal . point on the ground, m

  /// Lower bound of the distance of a point over the ground; negative when it can't tell.
  double clearance(const Vec3& point) const { return normal.dot(point) - top; }
};
GroundPlane plane_over(const IndexedSurface& ground, std::span<const std::uint32_t> faces);

struct LocalGround {
  struct Face {
    Vec3 normal;
    double offset;  ///< height of a point over the plane: normal . point - offset
    Vec3 middle;    ///< with `radius`, a ball around the face
    double radius;
    std::uint32_t face;
  };
  struct Edge {
    Vec3 start, direction;
    double length;
    std::uint32_t edge;
  };
  struct Corner {
    Vec3 point;
    std::uint32_t vertex;
  };
  std::vector<Face> faces;
  std::vector<Edge> edges;      ///< convex ones
  std::vector<Corner> corners;  ///< pointed ones
  GroundPlane plane;            ///< over all of it

  /// Takes up everything within `reach` of the point. Ordered by number.
  void gather(const IndexedSurface& ground, const Vec3& centre, double reach);
};

}  // namespace clast
