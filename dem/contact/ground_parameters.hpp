#pragma once
/// Contact parameters of ground zones.
#include <cmath>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Parameters of a ground zone. @cite garcia2022 (Table 2)
struct GroundParameters {
  double energy_restitution =
      0.01;                       ///< fraction of energy that an impact returns, e_n^2, in (0, 1]
  double friction = 0.7;          ///< friction coefficient mu
  double rolling_friction = 0.0;  ///< rolling friction coefficient mu_R
  /// Rolling length a, m: the rolling stiffness is the normal stiffness times a^2, as for springs
  /// at the distance a in front of and behind the contact. If 0, the default rolling stiffness is
  /// used.
  double rolling_length = 0.0;

  // Friction that grows while a block slides (docs/theory.md, Friction that grows). @cite leine2014
  /// Friction coefficient before any slip; `friction` is then its upper limit.
  double friction_min = 0.0;
  double slip_growth = 0.0;  ///< growth rate of friction with slip, 1/m; if 0, friction is constant
  /// Decay time of the stored slip after a contact, s; if 0, slip is forgotten at once.
  double slip_memory = 0.0;

  // Drag on the embedded part of a block (docs/theory.md, Scar drag). @cite lu2019
  /// Drag coefficient of the embedded part of a block; if 0, there is no drag.
  double scar_drag = 0.0;
  double soil_density = 0.0;  ///< density of the soil, kg/m^3

  /// Cell width of the grid that stores residual indentations, m; if 0, none are stored. Used only
  /// in simulations of several blocks under plastic laws.
  double soil_memory = 0.0;

  /// Returns the rolling stiffness on this ground, N m/rad.
  /// @param normal  normal stiffness, N/m
  /// @param default_stiffness  rolling stiffness of ground without a rolling length, N m/rad
  double rolling_stiffness(double normal, double default_stiffness) const {
    return rolling_length > 0.0 ? normal * rolling_length * rolling_length : default_stiffness;
  }

  /// Returns the friction coefficient after the block has slipped by a distance.
  /// @param slip  slip distance, m
  double slip_dependent_friction(double slip) const {
    if (!(slip_growth > 0.0)) return friction;
    return friction_min + (friction - friction_min) * std::atan(slip_growth * slip) * (2.0 / kPi);
  }

  void check(const std::string& zone) const;  ///< throws InputError naming zone, field and value
};

}  // namespace clast
