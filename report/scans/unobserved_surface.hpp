#pragma once
/// Parts of a closed scan that no scan data support.
#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/triangle_tree.hpp"
#include "reconstruct/field_scan.hpp"

namespace clast::report_detail {

/// Distance from the scan above which surface is new, as a fraction of the diagonal of the block.
inline constexpr double kNewSurfaceDistance = 0.004;

/// Finds triangles of the closed surface of a block that the scan did not observe. For a block of a
/// deposit, they are those on its estimated side, otherwise those of a closed underside and those
/// far from the scan.
class UnobservedSurface {
 public:
  /// @param block  must outlive the object
  /// @param read  scan as read, in the frame of the block; without triangles, distances from the
  ///              scan do not count
  UnobservedSurface(const FieldBlock& block, const TriangleMesh& read);

  /// True if a triangle of the closed surface is not observed.
  bool contains(std::uint32_t triangle);
  /// True if the nearest triangle of the closed surface is not observed.
  bool contains(const Vec3& place);

 private:
  bool is_unobserved(std::uint32_t triangle);

  const FieldBlock& block_;
  double reach_;
  std::unique_ptr<TriangleTree> surface_, scanned_, best_;
  std::uint32_t surface_hint_ = 0, best_hint_ = 0, scan_hint_ = 0;
  std::vector<signed char> answers_;  ///< one per triangle; -1: not known yet
};

}  // namespace clast::report_detail
