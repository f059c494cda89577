#include "reconstruct/repair/detail/crossings.hpp"

// Fairing inside needs a solver of linear equations; Eigen is here anyway.
#define CGAL_EIGEN3_ENABLED 1
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/exceptions.h>

#include "mesh/detail/cgal_mesh.hpp"

namespace clast::reconstruct_detail {

bool replace_intersecting_triangles(TriangleMesh& mesh) {
  mesh_detail::CgalMesh work = mesh_detail::to_cgal_mesh(mesh);
  try {
    if (!CGAL::Polygon_mesh_processing::remove_degenerate_faces(work)) return false;
    if (!CGAL::Polygon_mesh_processing::experimental::remove_self_intersections(work)) return false;
  } catch (const CGAL::Failure_exception&) {  // met something that it takes for impossible
    return false;
  }
  mesh = mesh_detail::from_cgal_mesh(work);
  return true;
}

}  // namespace clast::reconstruct_detail
