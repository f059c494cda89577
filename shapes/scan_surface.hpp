#pragma once
/// Closed scan prepared for distance queries.
#include <memory>

#include "mesh/triangle_mesh.hpp"

namespace clast {

struct TriangleNeighbours;
class TriangleTree;

/// Distance tree and neighbours of a scan, shared by all bodies compared with it. The mesh must
/// outlive it.
class ScanSurface {
 public:
  /// Builds the tree and finds the neighbours. The conversion is implicit, so that a mesh can be
  /// passed as a scan surface.
  /// @param mesh  closed, outward
  /// @throws GeometryError  if the mesh has no triangles
  ScanSurface(const TriangleMesh& mesh);  // NOLINT(google-explicit-constructor)
  ~ScanSurface();
  ScanSurface(ScanSurface&&) noexcept;
  ScanSurface& operator=(ScanSurface&&) noexcept;

  const TriangleMesh& mesh() const { return *mesh_; }
  const TriangleTree& tree() const { return *tree_; }
  const TriangleNeighbours& neighbours() const { return *neighbours_; }

 private:
  const TriangleMesh* mesh_;
  std::unique_ptr<TriangleTree> tree_;
  std::unique_ptr<TriangleNeighbours> neighbours_;
};

}  // namespace clast
