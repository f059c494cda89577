#include "massprops/solid.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "massprops/moments.hpp"
#include "massprops/principal_frame.hpp"

namespace clast {

using namespace massprops_detail;

MassProperties solid_mass_properties(const TriangleMesh& mesh, double density) {
  check_density(density);
  check_closed(mesh, "mesh");
  const Vec3 origin = vertex_mean(mesh);
  const SolidMoments moments = polyhedron_moments(mesh, origin);
  if (!(moments.volume > 0.0)) {
    throw GeometryError("mesh encloses " + format_significant(moments.volume, 6) +
                        " m3: its triangles face inward or it is flat; turn them outward first");
  }
  const MassProperties result = to_mass_properties(moments, origin, Mat3::Identity(), density);
  principal_frame(result);  // the gate: no solid breaks its inequalities
  return result;
}

}  // namespace clast
