#pragma once
/// The last steps of every field scan: an open or dirty surface of one block becomes a block.
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// A part beside the largest with more than this share of its area is no scrap.
inline constexpr double kFragmentArea = 0.1;

/// The surface of one block as it was taken from a scan, in units and axes of the file.
struct OpenBlock {
  TriangleMesh surface;
  std::optional<Plane> ground = {};       ///< what it stands on; none: it was scanned alone
  Vec3 centre = Vec3::Zero();             ///< of its box, where it stands on a ground
  const TriangleMesh* raw = nullptr;      ///< the mesh as read; null: a cloud
  RepairReport repaired = {};             ///< what was repaired so far, in metres; empty: a cloud
  const SurfaceUncertainty* uncertainty = nullptr;  ///< of the surface of a cloud; null: a mesh
  std::vector<std::string> notes = {};    ///< so far
};

/// Fills small holes, closes the unseen side, repairs, bounds what stays open, and turns the block
/// to metres with z up.
/// @param name  of the scan, for messages
/// @throws GeometryError  what `clean_scan` and `close_underside` throw
FieldBlock close_block(OpenBlock open, const std::string& name, const FieldScanOptions& options);

/// A mesh that needs no more than repair.
/// @throws GeometryError  what `clean_scan` throws
FieldBlock clean_block(const TriangleMesh& raw, const std::string& name,
                       const FieldScanOptions& options);

/// `report` with fillings of holes added.
/// @param fillings  in the file's units
/// @param area      of the surface with them, in the file's units
/// @param unit      metres per unit of the file
RepairReport report_with_fillings(RepairReport report, const std::vector<FilledHole>& fillings,
                           double area, double unit);

/// Is every point finite, and nearer to the origin than `kMaxCoordinate` in any unit?
bool are_coordinates_valid(const std::vector<Vec3>& points, double unit);

}  // namespace clast::reconstruct_detail
