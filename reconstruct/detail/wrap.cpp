#include "reconstruct/detail/wrap.hpp"

#include <CGAL/alpha_wrap_3.h>

#include <utility>
#include <vector>

#include "core/error.hpp"
#include "shapes/detail/cgal_mesh.hpp"
#include "shapes/mesh_topology.hpp"

namespace clast::detail {

TriangleMesh wrapped(const TriangleMesh& closed, const WrapShares& shares) {
  const MeshReport report = inspect(closed);
  if (!report.closed()) {
    throw GeometryError("only a closed surface can be wrapped, this one has " + report.summary() +
                        "; repair it first");
  }
  std::vector<CgalPoint> points;
  for (const Vec3& v : closed.vertices) points.emplace_back(v.x(), v.y(), v.z());
  const double diagonal = bounds(closed).diagonal();
  CgalMesh wrap;
  CGAL::alpha_wrap_3(points, closed.triangles, shares.bridged * diagonal,
                     shares.distance * diagonal, wrap);
  return from_cgal(wrap);
}

}  // namespace clast::detail
