#pragma once
#include "massprops/solid.hpp"

namespace clast {

/// The volume of a closed mesh, m^3.
inline double solid_volume(const TriangleMesh& mesh) {
  return solid_mass_properties(mesh, 1.0).volume;
}

}  // namespace clast
