#pragma once
/// Points of the block in a scan, separated from its surroundings.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Points of one block, in metres, z up.
struct BlockPoints {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> sources = {};  ///< index of each point in the cloud as read
  std::optional<Plane> ground = {};  ///< ground below the block; empty if it was scanned alone
  Vec3 centre = Vec3::Zero();        ///< centre of its bounding box, if there is a ground
  std::vector<std::string> notes = {};
};

/// Treatment of points so close to the ground that they may belong to it.
enum class FootPoints { kRemoved, kKept };

/// Removes duplicates, outliers, far points and, if present, the ground. A mesh is sampled evenly.
/// @param raw  mesh, or cloud if it has no triangles, in units and axes of the file
/// @param name  name of the scan, for messages
/// @throws InputError  if a point is out of range, or there are too few points
/// @throws GeometryError  if there are separate clusters but no ground, or only ground
BlockPoints extract_block_points(const TriangleMesh& raw, const std::string& name,
                                 const FieldScanOptions& options, FootPoints foot_points);

}  // namespace clast::reconstruct_detail
