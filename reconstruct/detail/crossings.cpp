#include "reconstruct/detail/crossings.hpp"

// Fairing inside needs a solver of linear equations; Eigen is here anyway.
#define CGAL_EIGEN3_ENABLED 1
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/exceptions.h>

#include "shapes/detail/cgal_mesh.hpp"

namespace clast::detail {

bool remove_crossings(TriangleMesh& mesh) {
  CgalMesh work = to_cgal(mesh);
  try {
    if (!CGAL::Polygon_mesh_processing::remove_degenerate_faces(work)) return false;
    if (!CGAL::Polygon_mesh_processing::experimental::remove_self_intersections(work)) return false;
  } catch (const CGAL::Failure_exception&) {  // met something that it takes for impossible
    return false;
  }
  mesh = from_cgal(work);
  return true;
}

}  // namespace clast::detail
