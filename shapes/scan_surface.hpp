#pragma once
/// Closed scan prepared for distance queries.
#include <memory>

#include "mesh/triangle_mesh.hpp"

namespace clast {

class TriangleTree;

/// Distance tree of a scan, shared by all bodies compared with it. The mesh must outlive it.
class ScanSurface {
 public:
  /// Builds the tree. The conversion is implicit, so that a mesh can be passed as a scan surface.
  /// @param mesh  closed, outward
  /// @throws GeometryError  if the mesh has no triangles
  ScanSurface(const TriangleMesh& mesh);  // NOLINT(google-explicit-constructor)
  ~ScanSurface();
  ScanSurface(ScanSurface&&) noexcept;
  ScanSurface& operator=(ScanSurface&&) noexcept;

  const TriangleMesh& mesh() const { return *mesh_; }
  const TriangleTree& tree() const { return *tree_; }

 private:
  const TriangleMesh* mesh_;
  std::unique_ptr<TriangleTree> tree_;
};

}  // namespace clast
