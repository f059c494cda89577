#include "reconstruct/detail/wrap.hpp"

#include <CGAL/alpha_wrap_3.h>

#include <utility>
#include <vector>

#include "core/error.hpp"
#include "shapes/detail/cgal_mesh.hpp"
#include "shapes/mesh_topology.hpp"

namespace clast::detail {

namespace {

/// Shares of the diagonal: width of what is bridged, and distance of the wrap.
/// Finer wraps cost with the square: this one takes some seconds.
constexpr double kAlpha = 1.0 / 60.0, kOffset = 1.0 / 1500.0;

}  // namespace

TriangleMesh wrapped(const TriangleMesh& closed) {
  const MeshReport report = inspect(closed);
  if (!report.closed()) {
    throw GeometryError("only a closed surface can be wrapped, this one has " + report.summary());
  }
  std::vector<CgalPoint> points;
  for (const Vec3& v : closed.vertices) points.emplace_back(v.x(), v.y(), v.z());
  const double diagonal = bounds(closed).diagonal();
  CgalMesh wrap;
  CGAL::alpha_wrap_3(points, closed.triangles, kAlpha * diagonal, kOffset * diagonal, wrap);
  return from_cgal(wrap);
}

}  // namespace clast::detail
