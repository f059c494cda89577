#pragma once
/// Bound of the distances of a flat triangle from a closed surface.
#include <array>
#include <cstdint>
#include <optional>

#include "core/types.hpp"
#include "shapes/scan_surface.hpp"

namespace clast::shapes_detail {

/// Heights of a closed surface above flat triangles. The distance of a triangle from the surface is
/// at most the largest height above its plane, or depth below it, of the part of the surface that
/// projects onto the triangle. That holds if this part covers the triangle. It does if it is
/// connected and all its faces are on the same side: the projection is then a covering map.
class CoveringHeight {
 public:
  /// Constructs the function of a surface, which must outlive this object.
  explicit CoveringHeight(const ScanSurface& surface) : surface_(surface) {}

  /// Returns the largest height or depth, m. Returns nothing if it is above `limit`, or if no
  /// connected part of the surface was found that covers the triangle.
  /// @param corners  of the flat triangle, anticlockwise as seen from outside
  /// @param outward  unit normal of the triangle
  /// @param start  a triangle of the surface near the flat one
  std::optional<double> operator()(const std::array<Vec3, 3>& corners, const Vec3& outward,
                                   std::uint32_t start, double limit) const;

 private:
  const ScanSurface& surface_;
};

}  // namespace clast::shapes_detail
