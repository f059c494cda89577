#pragma once
/// What a ground zone does to a block.
#include <cmath>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Parameters of a ground zone. @cite garcia2022 (Table 2)
struct GroundParameters {
  double energy_restitution = 0.01;  ///< e_n^2, in (0, 1]
  double friction = 0.7;             ///< mu
  double rolling_friction = 0.0;     ///< mu_R
  /// a, m: rolling resistance winds up with k_r = k_n a^2, as on springs at the distance a before
  /// and behind the contact (docs/theory.md, Rolling length). 0: with the k_r of the contacts.
  double rolling_length = 0.0;

  // Friction that grows while a block slides (docs/theory.md, Friction that grows). @cite leine2014
  double friction_min = 0.0;  ///< mu of a block that has not slid yet; `friction` is the limit then
  double slip_growth = 0.0;   ///< kappa, 1/m; 0: mu does not grow
  double slip_memory = 0.0;   ///< 1/beta, s: how long slip counts after the contact; 0: not at all

  // Drag on what of a block is in the ground (docs/theory.md, Scar drag). @cite lu2019
  double scar_drag = 0.0;     ///< C_d; 0: none
  double soil_density = 0.0;  ///< rho, kg/m^3

  /// Width of the cells in which the ground remembers dents from one contact to later ones, m
  /// (docs/theory.md, Soil memory). 0: it does not. Of worlds, under a law that leaves dents.
  double soil_memory = 0.0;

  /// k_r on this ground, N m/rad.
  /// @param normal   k_n, N/m
  /// @param without  k_r where the ground states no length, N m/rad
  double rolling_stiffness(double normal, double default_stiffness) const {
    return rolling_length > 0.0 ? normal * rolling_length * rolling_length : default_stiffness;
  }

  /// mu after sliding so far.
  /// @param slip  m
  double slip_dependent_friction(double slip) const {
    if (!(slip_growth > 0.0)) return friction;
    return friction_min + (friction - friction_min) * std::atan(slip_growth * slip) * (2.0 / kPi);
  }

  void check(const std::string& zone) const;  ///< throws InputError naming zone, field and value
};

}  // namespace clast
