#pragma once
/// Ground that yields: a dent stays where a block has pressed. @cite walton1986
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Normal force f on one ground zone, with the overlap h and the dent p, the part of it that stays
/// (docs/theory.md, Normal laws): f = k_1 h while h grows beyond what it was, f = k_2 (h - p) while
/// it shrinks, nothing above the dent. Where h grows again, f rises by k_3 dh up to k_1 h, so that
/// a block comes to rest in its own dent.
struct ElastoplasticLaw {
  static constexpr const char* kName = "elastoplastic";
  static constexpr bool kNeedsEffectiveMass = false;
  static constexpr bool kIsPlastic = true;
  /// k_3/k_2: an impact inside the dent that does not deepen it returns the inverse of its energy.
  static constexpr double kReloading = 2.0;

  double loading_stiffness = 0.0;    ///< k_1 = k_n, N/m
  double unloading_stiffness = 0.0;  ///< k_2 = k_n/e_n^2, N/m
  double reloading_stiffness = 0.0;  ///< k_3, N/m; k_1 where nothing stays

  static ElastoplasticLaw on_ground(double stiffness, const GroundParameters& ground);

  /// A load that is put on slowly, m g, reaches its depth by this. The dent of an impact is deeper.
  double static_stiffness() const { return loading_stiffness; }
  double stored_energy(double overlap, double residual_indentation) const {
    const double pressed = std::max(0.0, overlap - residual_indentation);
    return 0.5 * unloading_stiffness * pressed * pressed;
  }
  /// With the force that its patch has already; all of the overlap that this does not explain
  /// counts as dent.
  NormalState initial_state(double overlap, double /*rate*/, double /*effective_mass*/,
                            double patch_force) const {
    const double force = std::min(patch_force, loading_stiffness * overlap);
    return {force, overlap - force / unloading_stiffness};
  }
  double highest_frequency(double frequency) const {
    return frequency * std::sqrt(reloading_stiffness / loading_stiffness);
  }
  /// The force has no drop to speak of in an impact, and gives back what it stores at any speed.
  double force_drop(double /*overlap*/, double /*force*/) const { return 0.0; }
  double unloading_ratio(double /*stiffness*/) const { return 1.0; }

  NormalResponse integrate(const OverlapPath& path, const NormalState& state,
                           double effective_mass) const;
};

}  // namespace clast
