#pragma once
/// Contact parameters of ground zones.
#include <cmath>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Parameters of a ground zone. @cite garcia2022 (Table 2)
struct GroundParameters {
  double energy_restitution = 0.01;  ///< e_n^2, in (0, 1]
  double friction = 0.7;             ///< mu
  double rolling_friction = 0.0;     ///< mu_R
  /// Rolling length a, m. The rolling stiffness is k_r = k_n a^2, as if springs stood at the
  /// distance a in front of and behind the contact (docs/theory.md, Rolling length). If 0, the k_r
  /// of the contact stiffness is used.
  double rolling_length = 0.0;

  // Friction that grows while a block slides (docs/theory.md, Friction that grows). @cite leine2014
  double friction_min = 0.0;  ///< mu before any slip; `friction` is then the upper limit
  double slip_growth = 0.0;   ///< kappa, 1/m; if 0, mu is constant
  double slip_memory = 0.0;   ///< 1/beta, s: decay time of slip after a contact; if 0, no memory

  // Drag on what of a block is in the ground (docs/theory.md, Scar drag). @cite lu2019
  double scar_drag = 0.0;     ///< drag coefficient C_d; 0: no drag
  double soil_density = 0.0;  ///< rho, kg/m^3

  /// Cell width of the memory of residual indentations, m; if 0, there is no memory
  /// (docs/theory.md, Soil memory). Used only by worlds, and only under plastic laws.
  double soil_memory = 0.0;

  /// Returns k_r on this ground, N m/rad.
  /// @param normal  k_n, N/m
  /// @param default_stiffness  k_r of ground without rolling length, N m/rad
  double rolling_stiffness(double normal, double default_stiffness) const {
    return rolling_length > 0.0 ? normal * rolling_length * rolling_length : default_stiffness;
  }

  /// Returns mu after the block has slipped by a distance.
  /// @param slip  slip distance, m
  double slip_dependent_friction(double slip) const {
    if (!(slip_growth > 0.0)) return friction;
    return friction_min + (friction - friction_min) * std::atan(slip_growth * slip) * (2.0 / kPi);
  }

  void check(const std::string& zone) const;  ///< throws InputError naming zone, field and value
};

}  // namespace clast
