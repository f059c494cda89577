#include "reconstruct/detail/wrap.hpp"

#include <CGAL/alpha_wrap_3.h>

#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/detail/cgal_mesh.hpp"
#include "mesh/mesh_topology.hpp"

namespace clast::reconstruct_detail {

TriangleMesh wrapped(const TriangleMesh& closed, const WrapShares& shares) {
  const MeshReport report = inspect(closed);
  if (!report.closed()) {
    throw GeometryError("only a closed surface can be wrapped, this one has " + report.summary() +
                        "; repair it first");
  }
  std::vector<mesh_detail::CgalPoint> points;
  for (const Vec3& v : closed.vertices) points.emplace_back(v.x(), v.y(), v.z());
  const double diagonal = bounds(closed).diagonal();
  mesh_detail::CgalMesh wrap;
  CGAL::alpha_wrap_3(points, closed.triangles, shares.bridged * diagonal,
                     shares.distance * diagonal, wrap);
  return mesh_detail::from_cgal(wrap);
}

}  // namespace clast::reconstruct_detail
