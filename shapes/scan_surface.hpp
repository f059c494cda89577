#pragma once
/// A closed scan made ready for many distance queries.
#include <memory>

#include "mesh/triangle_mesh.hpp"

namespace clast {

class TriangleTree;

/// Built once per scan and used for every body that is fitted to it or judged against it. Refers to
/// the mesh, which must stay.
class ScanSurface {
 public:
  /// Implicit: wherever a surface to compare with is wanted, a mesh will do.
  /// @param mesh  closed, outward
  /// @throws GeometryError  the mesh has no triangles
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
