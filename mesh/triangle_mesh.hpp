#pragma once
/// The mesh everything is exchanged in.
#include <array>
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "core/types.hpp"

namespace clast {

/// Stands for "no vertex", "no triangle" or "no component" where an index is expected.
inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// Vertices in metres and triangles as vertex indices, counter-clockwise seen from outside.
/// Plain data: nothing cached, nothing guaranteed; `inspect_mesh` tells what it is worth.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Axis-aligned bounds; empty when `low` exceeds `high`.
struct Bounds {
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = Vec3::Constant(-1e300);

  void include(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  double diagonal() const { return (high - low).norm(); }
};

Bounds bounds(const TriangleMesh& mesh);
double triangle_area(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);  ///< m^2
double surface_area(const TriangleMesh& mesh);                                           ///< m^2
/// Volume of the space that the triangles enclose, summed about the middle of their bounds: below
/// zero where they face inwards, without meaning where they are not closed. m^3
double signed_volume(const TriangleMesh& mesh);
TriangleMesh transformed(TriangleMesh mesh, const Pose& to_from);
TriangleMesh scaled(TriangleMesh mesh, double factor);  ///< about the origin; factor > 0
/// Vertices of `other` appended to those of `mesh`, triangles renumbered.
TriangleMesh merged(TriangleMesh mesh, const TriangleMesh& other);

}  // namespace clast
