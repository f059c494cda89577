#pragma once
/// Elastoplastic normal law with residual indentation. @cite walton1986
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Elastoplastic normal law: f is the normal force, h the overlap and p the residual indentation.
/// Loading beyond the previous maximum follows f = k_1 h with the loading stiffness k_1. Unloading
/// follows f = k_2 (h - p) with the unloading stiffness k_2. Reloading has the reloading stiffness
/// k_3 until f = k_1 h (docs/theory.md, Normal laws).
struct ElastoplasticLaw {
  static constexpr const char* kName = "elastoplastic";
  static constexpr bool kNeedsEffectiveMass = false;
  static constexpr bool kIsPlastic = true;
  /// Reloading stiffness divided by unloading stiffness. Its inverse is the fraction of energy that
  /// an impact without new indentation returns.
  static constexpr double kReloadingRatio = 2.0;

  double loading_stiffness = 0.0;    ///< k_1, equal to the normal stiffness k_n, N/m
  double unloading_stiffness = 0.0;  ///< k_2: normal stiffness divided by energy restitution, N/m
  double reloading_stiffness = 0.0;  ///< k_3, N/m; k_1 if there is no residual indentation

  static ElastoplasticLaw on_ground(double stiffness, const GroundParameters& ground);

  /// Returns the stiffness under a slowly applied load, N/m.
  double static_stiffness() const { return loading_stiffness; }
  double stored_energy(double overlap, double residual_indentation) const {
    const double pressed = std::max(0.0, overlap - residual_indentation);
    return 0.5 * unloading_stiffness * pressed * pressed;
  }
  /// Returns the initial state of a new contact. Its force is that of the contact patch. The
  /// overlap in excess of that force becomes residual indentation.
  NormalForceState initial_state(double overlap, double /*rate*/, double /*effective_mass*/,
                                 double patch_force) const {
    const double force = std::min(patch_force, loading_stiffness * overlap);
    return {force, overlap - force / unloading_stiffness};
  }
  double highest_frequency(double frequency) const {
    return frequency * std::sqrt(reloading_stiffness / loading_stiffness);
  }
  /// Returns the drop of the force when loading turns to unloading, which is zero for this law.
  double force_drop(double /*overlap*/, double /*force*/) const { return 0.0; }
  double unloading_ratio(double /*stiffness*/) const { return 1.0; }

  NormalForceResponse integrate(const OverlapPath& path, const NormalForceState& state,
                                double effective_mass) const;
};

}  // namespace clast
