#include "mesh/isotropic_remeshing.hpp"

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/detail/cgal_mesh.hpp"
#include "mesh/mesh_topology.hpp"

namespace clast {
namespace {

// Rounds of split, collapse, flip and shift; lengths settle within three.
constexpr unsigned kRounds = 5;
constexpr double kMaxTriangles = 1e7;

}  // namespace

TriangleMesh remesh_isotropic(const TriangleMesh& mesh, double edge_length) {
  const MeshReport report = inspect_mesh(mesh);
  if (!report.is_closed() || !report.is_oriented()) {
    throw GeometryError("remeshing: the surface is not closed: " + report.summary());
  }
  if (!(edge_length > 0.0) || !std::isfinite(edge_length)) {
    throw InputError("remeshing: edge length " + format_significant(edge_length, 6) +
                     " m must be positive");
  }
  // An equilateral triangle has sqrt(3)/4 of the square of its edge.
  const double triangles = surface_area(mesh) * 4.0 / (std::sqrt(3.0) * edge_length * edge_length);
  if (triangles > kMaxTriangles) {
    throw InputError("remeshing: edges of " + format_significant(edge_length, 6) +
                     " m would take " + format_significant(triangles, 3) +
                     " triangles; give a longer edge length");
  }
  mesh_detail::CgalMesh work = mesh_detail::to_cgal_mesh(mesh);
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
      work.faces(), edge_length, work,
      CGAL::Polygon_mesh_processing::parameters::number_of_iterations(kRounds));
  return mesh_detail::from_cgal_mesh(work);
}

}  // namespace clast
