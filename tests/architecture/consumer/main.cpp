// Exit status 0 when a tetrahedron weighs what it should, a campaign file that is not there is
// refused, and there is no report about no runs.
#include <cmath>

#include "core/error.hpp"
#include "massprops/solid.hpp"
#include "report/comparison_report.hpp"
#include "study/campaign.hpp"

int main() {
  clast::TriangleMesh tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const double mass = clast::solid_mass_properties(tetrahedron, 2400.0).mass;
  if (std::abs(mass - 400.0) > 1e-9) return 1;
  try {
    clast::read_campaign("missing.toml");
    return 1;
  } catch (const clast::InputError&) {
  }
  try {
    clast::write_comparison(clast::compare({}), "report");
    return 1;
  } catch (const clast::InputError&) {
  }
  return 0;
}
