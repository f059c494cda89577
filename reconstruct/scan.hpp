#pragma once
/// Field scans to closed, outward meshes.
#include <filesystem>
#include <string>
#include <vector>

#include "shapes/mesh_topology.hpp"
#include "shapes/triangle_mesh.hpp"

namespace clast {

/// How a scan file is read.
struct ScanOptions {
  double unit = 1.0;               ///< metres per unit of the file
  std::string up = "z";            ///< axis of the file that points up: "y" or "z"
  double weld_tolerance = 1e-5;    ///< share of the diagonal within which vertices are one
  std::size_t fan_hole_edges = 4;  ///< holes with at most this many border edges are closed
  bool keep_inner_shells =
      false;  ///< closed shells inside stay as cavities; false: rock fills them

  void check() const;  ///< throws InputError naming the field and its value
};

/// A scan that became a closed mesh, and what was done to it.
struct Scan {
  TriangleMesh mesh;                ///< closed, 2-manifold, outward; metres, z up; cavities inward
  MeshReport as_read;               ///< before anything was mended, after welding
  std::size_t inner_shells = 0;     ///< bubbles inside, dropped unless they were to be kept
  double inner_shell_volume = 0.0;  ///< of all of them, m^3
  std::vector<std::string> notes;   ///< each mend in words, with counts
};

/// Reads, scales, welds, orients outward, closes tiny holes by a fan, and drops inner shells or
/// turns them to bound cavities. Surfaces inside a bubble (loose stones) are dropped always.
/// @throws InputError     what `read_mesh` throws
/// @throws GeometryError  anything that would need more repair: names the defect and its place
Scan read_scan(const std::filesystem::path& path, const ScanOptions& options = {});

/// The same for a mesh that is already in memory; `name` is used in messages.
Scan cleaned_scan(TriangleMesh raw, const std::string& name, const ScanOptions& options = {});

}  // namespace clast
