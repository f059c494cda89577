#include "shapes/scan_surface.hpp"

#include "core/error.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast {

ScanSurface::ScanSurface(const TriangleMesh& mesh) : mesh_(&mesh) {
  if (mesh.triangles.empty()) {
    throw GeometryError("the scan has no triangles, so nothing can be compared with it");
  }
  tree_ = std::make_unique<TriangleTree>(mesh);
  neighbours_ = std::make_unique<TriangleNeighbours>(triangle_neighbours(mesh));
}

ScanSurface::~ScanSurface() = default;
ScanSurface::ScanSurface(ScanSurface&&) noexcept = default;
ScanSurface& ScanSurface::operator=(ScanSurface&&) noexcept = default;

}  // namespace clast
