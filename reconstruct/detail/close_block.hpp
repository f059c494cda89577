#pragma once
/// Final steps of field scans: closing and repairing the surface of one block.
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Area fraction of the largest component above which another component is not debris.
inline constexpr double kFragmentArea = 0.1;

/// Surface of one block as extracted from a scan, in units and axes of the file.
struct OpenBlock {
  TriangleMesh surface;
  std::optional<Plane> ground = {};   ///< below the block; empty if it was scanned alone
  Vec3 centre = Vec3::Zero();         ///< of its box, if there is a ground
  const TriangleMesh* raw = nullptr;  ///< mesh as read; null for a cloud
  RepairReport repaired = {};         ///< repairs so far, in metres; empty for a cloud
  const SurfaceUncertainty* uncertainty = nullptr;  ///< of a cloud's surface; null for a mesh
  std::vector<std::string> notes = {};              ///< so far
};

/// Fills small holes, closes the unobserved side, repairs, bounds the uncertainty, and transforms
/// the block to metres with z up.
/// @param name  of the scan, for messages
/// @throws GeometryError  as `clean_scan` and `close_underside`
FieldBlock close_block(OpenBlock open, const std::string& name, const FieldScanOptions& options);

/// Makes a block from a mesh that only needs repair.
/// @throws GeometryError  as `clean_scan`
FieldBlock clean_block(const TriangleMesh& raw, const std::string& name,
                       const FieldScanOptions& options);

/// Returns `report` with added hole fillings.
/// @param fillings  in the file's units
/// @param area  of the surface with them, in the file's units
/// @param unit  metres per unit of the file
RepairReport report_with_fillings(RepairReport report, const std::vector<FilledHole>& fillings,
                                  double area, double unit);

/// True if all points are finite and within `kMaxCoordinate` of the origin.
bool are_coordinates_valid(const std::vector<Vec3>& points, double unit);

}  // namespace clast::reconstruct_detail
