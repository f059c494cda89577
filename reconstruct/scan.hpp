#pragma once
/// Field scans to closed, outward meshes in metres.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair.hpp"

namespace clast {

/// How a scan file is read.
struct ScanOptions {
  double unit = 1.0;  ///< metres per unit of the file
  /// Axis of the file that points up: "y", "z", or "auto", y of glTF files and z of all others.
  std::string up = "auto";
  /// Of a cloud in text: names or numbers from 1 of the columns x, y and z; empty: by its heading.
  std::vector<std::string> columns = {};
  RepairOptions repair = {};

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScanOptions& options, Visit&& visit) {
  const auto& [unit, up, columns, repair] = options;
  visit("unit", unit);
  visit("up", up);
  visit("columns", columns);
  visit("repair", repair);
}

/// The options with the `up` that "auto" stands for in this file. Without a file it stands for z.
ScanOptions resolve_options(const std::filesystem::path& file, ScanOptions options);

/// A scan that became a closed mesh, and what was done to it.
struct Scan {
  TriangleMesh mesh;               ///< closed, 2-manifold, outward; metres, z up; cavities inward
  RepairReport report;             ///< places in the coordinates of the file
  std::vector<std::string> notes;  ///< each repair in words, with counts, and doubts about the file
};

/// Reads, repairs, scales and turns upright.
/// @throws InputError     what `read_mesh` throws; coordinates that lost the block's shape because
///                        the file keeps too few digits of them
/// @throws GeometryError  what `repair_mesh` throws, with the file's name
Scan read_scan(const std::filesystem::path& path, const ScanOptions& options = {});

/// The same for a mesh that is already in memory; `name` is used in messages.
/// @param turn  of the metres, z up: applied before the repair, so that the surface returned is the
///              one that was verified (turning it afterwards rounds every vertex anew)
Scan clean_scan(const TriangleMesh& raw, const std::string& name, const ScanOptions& options = {},
                const std::optional<Pose>& upright_pose = {});

}  // namespace clast
