#pragma once
/// The ground near a part of a block, copied together so that many queries read little memory.
#include <cstdint>
#include <vector>

#include "dem/detail/indexed_surface.hpp"

namespace clast {

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

  /// Takes up everything within `reach` of the point. Ordered by number.
  void gather(const IndexedSurface& ground, const Vec3& centre, double reach);
};

}  // namespace clast
