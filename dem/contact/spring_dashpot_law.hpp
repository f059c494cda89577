#pragma once
/// Linear spring-dashpot normal law without tension, for comparison with other studies.
/// @cite schwager2007
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Linear spring and dashpot: the normal force is max(0, k_n h + c dh/dt) for the overlap h, with
/// normal stiffness k_n. The damping coefficient c is such that a single contact returns the
/// fraction e_n^2 of its energy.
struct SpringDashpotLaw {
  static constexpr const char* kName = "spring-dashpot";
  static constexpr bool kNeedsEffectiveMass = true;
  static constexpr bool kIsPlastic = false;

  double stiffness = 0.0;      ///< normal stiffness k_n, N/m
  double damping_ratio = 0.0;  ///< damping coefficient divided by its critical value

  static SpringDashpotLaw on_ground(double stiffness, const GroundParameters& ground);

  double static_stiffness() const { return stiffness; }
  double stored_energy(double overlap, double /*residual_indentation*/) const {
    return 0.5 * stiffness * overlap * overlap;
  }
  NormalForceState initial_state(double overlap, double rate, double effective_mass,
                                 double /*patch_force*/) const {
    return {std::max(0.0, stiffness * overlap + damping_coefficient(effective_mass) * rate), 0.0};
  }
  /// Returns the highest rate of a contact, rad/s: the frequency of the undamped spring, or the
  /// fastest decay rate if the contact is overdamped.
  /// @param frequency  frequency of the undamped spring, rad/s
  double highest_frequency(double frequency) const;
  double force_drop(double overlap, double force) const { return force - stiffness * overlap; }
  double unloading_ratio(double reference_stiffness) const {
    return stiffness / reference_stiffness;
  }

  NormalForceResponse integrate(const OverlapPath& path, const NormalForceState& state,
                                double effective_mass) const;

  double damping_coefficient(double effective_mass) const {
    return 2.0 * damping_ratio * std::sqrt(stiffness * effective_mass);
  }
};

/// Returns the damping ratio with which a contact returns the fraction `energy_restitution` of its
/// energy. The contact ends when its force vanishes.
double damping_ratio_for_restitution(double energy_restitution);

}  // namespace clast
