#include "shapes/scan_surface.hpp"

#include "core/error.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast {

ScanSurface::ScanSurface(const TriangleMesh& mesh) : mesh_(&mesh) {
  if (mesh.triangles.empty()) {
    throw GeometryError("nothing can be compared with a scan that has no triangles");
  }
  tree_ = std::make_unique<TriangleTree>(mesh);
}

ScanSurface::~ScanSurface() = default;
ScanSurface::ScanSurface(ScanSurface&&) noexcept = default;
ScanSurface& ScanSurface::operator=(ScanSurface&&) noexcept = default;

}  // namespace clast
