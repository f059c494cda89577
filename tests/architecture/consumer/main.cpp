// Exit status 0 when a tetrahedron weighs what it should, and a campaign file that is not there is
// refused: with the second, every library of clast is linked.
#include <cmath>

#include "core/error.hpp"
#include "massprops/solid.hpp"
#include "study/campaign.hpp"

int main() {
  clast::TriangleMesh tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const double mass = clast::solid_mass_properties(tetrahedron, 2400.0).mass;
  if (std::abs(mass - 400.0) > 1e-9) return 1;
  try {
    clast::read_campaign("missing.toml");
  } catch (const clast::InputError&) {
    return 0;
  }
  return 1;
}
