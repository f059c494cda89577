#pragma once
/// Triangle mesh: type, bounds, area and volume.
#include <array>
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "core/types.hpp"

namespace clast {

/// Index value for "no vertex", "no triangle" or "no component".
inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// Triangle mesh. Vertices are in metres. Triangles are vertex indices, counter-clockwise seen from
/// outside. Validity is not guaranteed; see `inspect_mesh`.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Axis-aligned bounding box; empty if `low` exceeds `high`.
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
/// Returns the enclosed volume, m^3; negative if triangles face inwards, meaningless if open.
double signed_volume(const TriangleMesh& mesh);
TriangleMesh transformed(TriangleMesh mesh, const Pose& to_from);
TriangleMesh scaled(TriangleMesh mesh, double factor);  ///< scales about the origin; factor > 0
TriangleMesh merged(TriangleMesh mesh, const TriangleMesh& other);

}  // namespace clast
