#pragma once
/// The bounds that are stated with a block: what its scan leaves open of volume and sides.
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_tree.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"
#include "reconstruct/repair/repair_report.hpp"
#include "reconstruct/underside/underside.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// What was scanned of a surface that was repaired since.
class ScannedSurface {
 public:
  /// @param raw  as read; its faces may be of any kind
  explicit ScannedSurface(const TriangleMesh& raw);
  /// @param points  of a cloud, on its surface; more than six
  explicit ScannedSurface(std::span<const Vec3> points);

  /// Is the place on a triangle as read, or between points as near as others are? Fillings,
  /// replaced spikes and the like are not.
  bool contains(const Vec3& position) const;

 private:
  TriangleMesh surface_;
  std::optional<TriangleTree> tree_;
  double reach_ = 0.0;
  std::optional<PointTree> points_;
  std::vector<double> spacings_;
};

/// A closed surface and what is known of it; lengths in units of the file.
struct ClosedScan {
  const TriangleMesh& surface;
  double unit = 1.0;                                ///< m
  const ScannedSurface* scanned = nullptr;          ///< null: all of the surface was
  const SurfaceUncertainty* uncertainty = nullptr;  ///< null: the surface is exact
};

/// The bounds of a block, with notes on what may be behind the unseen parts, for those of the scan.
struct NotedBounds : VolumeBracket {
  std::vector<std::string> notes;
};

/// @param report  of the repair, in metres
/// @returns m, m^3; none if the bounds are so narrow that they say nothing
std::optional<NotedBounds> bracket_closed_scan(const ClosedScan& scan, const RepairReport& report);

/// @param side    m
/// @param report  of the repair, in metres: copies of the surface widen the bounds
VolumeBracket bracket_underside(const Underside& side, const RepairReport& report);

}  // namespace clast::reconstruct_detail
