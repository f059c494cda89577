#pragma once
/// Final steps of field scans: closing and repairing the surface of one block.
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Maximum area of debris as a fraction of the area of the largest component.
inline constexpr double kMaxDebrisAreaFraction = 0.1;

/// Surface of one block as extracted from a scan, in units and axes of the file.
struct OpenBlock {
  TriangleMesh surface;
  std::optional<Plane> ground = {};   ///< ground below the block; empty if it was scanned alone
  Vec3 centre = Vec3::Zero();         ///< centre of its bounding box, if there is a ground
  const TriangleMesh* raw = nullptr;  ///< mesh as read; null for a cloud
  RepairReport repaired = {};         ///< previous repairs, in metres; empty for a cloud
  const SurfaceUncertainty* uncertainty =
      nullptr;                          ///< uncertainty of the surface of a cloud; null for a mesh
  std::vector<std::string> notes = {};  ///< previous notes
};

/// Closes and repairs the surface of a block: fills small holes, closes the unobserved side, and
/// computes bounds of the volume. Transforms the block to metres with z up.
/// @param name  name of the scan, for messages
/// @throws GeometryError  if `clean_scan` or `close_underside` throws
FieldBlock close_block(OpenBlock open, const std::string& name, const FieldScanOptions& options);

/// Makes a block from a mesh that only needs repair.
/// @throws GeometryError  if `clean_scan` throws
FieldBlock clean_block(const TriangleMesh& raw, const std::string& name,
                       const FieldScanOptions& options);

/// Returns a repair report to which hole fillings are added.
/// @param fillings  in the file's units
/// @param area  area of the surface with the fillings, in the file's units
/// @param unit  metres per unit of the file
RepairReport report_with_fillings(RepairReport report, const std::vector<FilledHole>& fillings,
                                  double area, double unit);

/// True if all points are finite and within `kMaxCoordinate` of the origin.
bool are_coordinates_valid(const std::vector<Vec3>& points, double unit);

/// Converts a point from the units and axes of the file to metres, z up.
Vec3 in_metres(Vec3 point, const ScanOptions& options);

/// Adds a note on a rotation that makes the ground horizontal, if it exceeds one degree.
void note_tilt(const Quat& rotation, std::vector<std::string>& notes);

}  // namespace clast::reconstruct_detail
