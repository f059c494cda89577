#pragma once
/// Reading of scans as closed, outward meshes in metres.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair.hpp"

namespace clast {

struct ScanOptions {
  double unit = 1.0;  ///< metres per unit of the file
  /// Up axis of the file: "y", "z" or "auto". If "auto", y is used for glTF files and z for others.
  std::string up = "auto";
  /// Columns x, y and z of a text cloud, each given by name or by number from 1. If empty, the
  /// heading of the file determines them.
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

/// Replaces "auto" of `up` by the axis of the file, or by "z" if there is no file.
ScanOptions resolve_scan_options(const std::filesystem::path& file, ScanOptions options);

/// Closed mesh of a scan, with its repairs.
struct Scan {
  TriangleMesh mesh;               ///< closed 2-manifold, outward, m, z up; cavities inward
  RepairReport report;             ///< positions in file coordinates
  std::vector<std::string> notes;  ///< repairs with counts, and warnings about the file
};

/// Reads, repairs, scales and rotates a scan to z up.
/// @throws InputError  if `read_mesh` throws, or if the file stores too few digits for the shape
/// @throws GeometryError  if `repair_mesh` throws; names the file
Scan read_scan(const std::filesystem::path& path, const ScanOptions& options = {});

/// Repairs, scales and rotates a mesh in memory like `read_scan`. Messages refer to it as `name`.
/// @param upright_pose  pose in metres, z up. It is applied before the repair, because a later
///                      rotation would round the vertices of the verified surface
Scan clean_scan(const TriangleMesh& raw, const std::string& name, const ScanOptions& options = {},
                const std::optional<Pose>& upright_pose = {});

}  // namespace clast
