#pragma once
/// Volume bracket of a closed scan, with notes.
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

/// Scanned part of a repaired surface.
class ScannedSurface {
 public:
  /// Constructs the scanned part of a mesh.
  /// @param raw  mesh as read; may have defects
  explicit ScannedSurface(const TriangleMesh& raw);
  /// Constructs the scanned part of a point cloud.
  /// @param points  more than six points of a cloud, on its surface
  explicit ScannedSurface(std::span<const Vec3> points);

  /// True if the position is on a scanned triangle, or between points at their usual spacing. False
  /// on fillings and other repairs.
  bool contains(const Vec3& position) const;

 private:
  TriangleMesh surface_;
  std::optional<TriangleTree> tree_;
  double reach_ = 0.0;
  std::optional<PointTree> points_;
  std::vector<double> spacings_;
};

/// Closed surface with its scanned part and uncertainty. Lengths are in units of the file.
struct ClosedScan {
  const TriangleMesh& surface;
  double unit = 1.0;                                ///< m per unit of the file
  const ScannedSurface* scanned = nullptr;          ///< null if the whole surface was scanned
  const SurfaceUncertainty* uncertainty = nullptr;  ///< null if the surface is exact
};

/// Volume bracket with notes on possible cavities.
struct VolumeBracketWithNotes : VolumeBracket {
  std::vector<std::string> notes;
};

/// Computes bounds of the volume of a closed scan.
/// @param report  report of the repair, in metres
/// @returns bounds in m and m^3; empty if they are so narrow that they are insignificant
std::optional<VolumeBracketWithNotes> compute_closed_scan_bracket(const ClosedScan& scan,
                                                                  const RepairReport& report);

/// Computes bounds of the volume of a block with a closed underside.
/// @param side  closed scan, in metres
/// @param report  report of the repair, in metres; copies of the surface widen the bounds
VolumeBracket compute_underside_bracket(const Underside& side, const RepairReport& report);

}  // namespace clast::reconstruct_detail
