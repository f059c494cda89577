#pragma once
/// Synthetic scans with the defects of photogrammetry exports.
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// Writes three scans: a block on a patch of ground with loose fragments; a block open at the
/// bottom; a block with spikes and a hole.
std::vector<NamedMesh> dirty_scans();

}  // namespace clast
