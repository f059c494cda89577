#pragma once
/// Scans as photogrammetry exports them before anyone cleaned them.
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// A block that grows out of a patch of ground, with crumbs floating beside it; a block open below;
/// a block with spikes and a hole.
std::vector<NamedMesh> dirty_scans();

}  // namespace clast
