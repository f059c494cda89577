#pragma once
/// What a ground zone does to a block.
#include <string>

namespace clast {

/// Parameters of a ground zone. @cite garcia2022 (Table 2)
struct GroundParameters {
  double energy_restitution = 0.01;  ///< e_n^2, in (0, 1]
  double friction = 0.7;             ///< mu
  double rolling_friction = 0.0;     ///< mu_R

  void check(const std::string& zone) const;  ///< throws InputError naming zone, field and value
};

}  // namespace clast
