#include "reconstruct/repair/detail/wrap.hpp"

#include "core/error.hpp"
#include "mesh/alpha_wrap.hpp"
#include "mesh/mesh_topology.hpp"

namespace clast::reconstruct_detail {

TriangleMesh wrap_surface(const TriangleMesh& closed, const WrapParameters& parameters) {
  const MeshReport report = inspect_mesh(closed);
  if (!report.is_closed()) {
    throw GeometryError("only a closed surface can be wrapped, but this one has " +
                        report.summary() + "; repair it first");
  }
  const double diagonal = bounds(closed).diagonal();
  return alpha_wrap(closed, parameters.alpha * diagonal, parameters.offset * diagonal);
}

}  // namespace clast::reconstruct_detail
