#include "mesh/alpha_wrap.hpp"

#include <CGAL/alpha_wrap_3.h>

#include <vector>

#include "mesh/detail/cgal_mesh.hpp"

namespace clast {

TriangleMesh alpha_wrap(const TriangleMesh& soup, double alpha, double offset) {
  std::vector<mesh_detail::CgalPoint> points;
  for (const Vec3& v : soup.vertices) points.emplace_back(v.x(), v.y(), v.z());
  mesh_detail::CgalMesh wrap;
  CGAL::alpha_wrap_3(points, soup.triangles, alpha, offset, wrap);
  return mesh_detail::from_cgal_mesh(wrap);
}

}  // namespace clast
