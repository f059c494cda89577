#pragma once
/// Linear spring-dashpot normal law without tension, for comparison with other studies.
/// @cite schwager2007
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Normal force f on one ground zone at overlap h: f = max(0, k_n h + c dh/dt). The damping c is
/// such that a single contact returns the fraction e_n^2 of its energy.
struct SpringDashpotLaw {
  static constexpr const char* kName = "spring-dashpot";
  static constexpr bool kNeedsEffectiveMass = true;
  static constexpr bool kIsPlastic = false;

  double stiffness = 0.0;      ///< k_n, N/m
  double damping_ratio = 0.0;  ///< c / (2 sqrt(k_n m)), m the effective mass of the contact

  static SpringDashpotLaw on_ground(double stiffness, const GroundParameters& ground);

  double static_stiffness() const { return stiffness; }
  double stored_energy(double overlap, double /*dent*/) const {
    return 0.5 * stiffness * overlap * overlap;
  }
  NormalForceState initial_state(double overlap, double rate, double effective_mass,
                                 double /*patch_force*/) const {
    return {std::max(0.0, stiffness * overlap + damping_coefficient(effective_mass) * rate), 0.0};
  }
  /// Returns the fastest rate, rad/s, of a contact whose spring alone has the given frequency.
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

/// Returns the damping ratio for an energy restitution e_n^2, if the contact ends when its force
/// vanishes. It solves e_n = exp(-2 theta / tan theta) with theta = acos(ratio). For ratios above
/// 1, it solves e_n = exp(-2 eta / tanh eta) with eta = acosh(ratio).
double damping_ratio_for_restitution(double energy_restitution);

}  // namespace clast
