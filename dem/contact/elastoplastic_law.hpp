#pragma once
/// Elastoplastic normal law with residual indentation. @cite walton1986
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Normal force f on one ground zone, with overlap h and residual indentation p (docs/theory.md,
/// Normal laws). During loading beyond the previous maximum, f = k_1 h. During unloading, f = k_2
/// (h - p), and 0 if h < p. During reloading, f rises by k_3 dh up to k_1 h, so that a block comes
/// to rest in its own indentation.
struct ElastoplasticLaw {
  static constexpr const char* kName = "elastoplastic";
  static constexpr bool kNeedsEffectiveMass = false;
  static constexpr bool kIsPlastic = true;
  /// Ratio k_3/k_2. An impact without new indentation returns the fraction k_2/k_3 of its energy.
  static constexpr double kReloading = 2.0;

  double loading_stiffness = 0.0;    ///< k_1 = k_n, N/m
  double unloading_stiffness = 0.0;  ///< k_2 = k_n/e_n^2, N/m
  double reloading_stiffness = 0.0;  ///< k_3, N/m; k_1 if there is no residual indentation

  static ElastoplasticLaw on_ground(double stiffness, const GroundParameters& ground);

  /// Stiffness under a slowly applied load m g. Impacts leave deeper indentations.
  double static_stiffness() const { return loading_stiffness; }
  double stored_energy(double overlap, double residual_indentation) const {
    const double pressed = std::max(0.0, overlap - residual_indentation);
    return 0.5 * unloading_stiffness * pressed * pressed;
  }
  /// Starts with the force of the contact patch. The part of the overlap that this force does not
  /// explain becomes residual indentation.
  NormalState initial_state(double overlap, double /*rate*/, double /*effective_mass*/,
                            double patch_force) const {
    const double force = std::min(patch_force, loading_stiffness * overlap);
    return {force, overlap - force / unloading_stiffness};
  }
  double highest_frequency(double frequency) const {
    return frequency * std::sqrt(reloading_stiffness / loading_stiffness);
  }
  /// The force has no significant drop when loading turns to unloading. The stored energy is
  /// returned at any speed.
  double force_drop(double /*overlap*/, double /*force*/) const { return 0.0; }
  double unloading_ratio(double /*stiffness*/) const { return 1.0; }

  NormalResponse integrate(const OverlapPath& path, const NormalState& state,
                           double effective_mass) const;
};

}  // namespace clast
