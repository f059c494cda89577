#pragma once
/// Reading of scans to closed, outward meshes in metres.
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
  /// Up axis of the file: "y", "z", or "auto", y for glTF files and z for others.
  std::string up = "auto";
  /// Columns x, y and z of a text cloud, by name or 1-based number; empty: by its heading.
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

/// Resolves "auto" of `up` for a file; z without a file.
ScanOptions resolve_options(const std::filesystem::path& file, ScanOptions options);

/// Closed mesh of a scan, with its repairs.
struct Scan {
  TriangleMesh mesh;               ///< closed, 2-manifold, outward; metres, z up; cavities inward
  RepairReport report;             ///< positions in file coordinates
  std::vector<std::string> notes;  ///< repairs with counts, and warnings about the file
};

/// Reads, repairs, scales and rotates a scan to z up.
/// @throws InputError  as `read_mesh`; if too few stored digits have lost the block's shape
/// @throws GeometryError  as `repair_mesh`, with the file's name
Scan read_scan(const std::filesystem::path& path, const ScanOptions& options = {});

/// Processes a mesh in memory; `name` is used in messages.
/// @param upright_pose  in metres, z up, applied before the repair, so that the returned surface is
///                      the verified one (a later rotation would round all vertices)
Scan clean_scan(const TriangleMesh& raw, const std::string& name, const ScanOptions& options = {},
                const std::optional<Pose>& upright_pose = {});

}  // namespace clast
