#pragma once
/// Energy-restitution normal law: loading with k_n, unloading with k_n e_n^2. @cite garcia2022 (Eq.
/// 2)
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Energy-restitution law: while the overlap h grows, the normal force f rises by k_n dh; otherwise
/// f = k_n e_n^2 h. k_n is the normal stiffness, e_n^2 the returned fraction of energy.
struct EnergyRestitutionLaw {
  static constexpr const char* kName = "energy-restitution";
  static constexpr bool kNeedsEffectiveMass = false;
  static constexpr bool kIsPlastic = false;

  double loading_stiffness = 0.0;    ///< k_n, N/m
  double unloading_stiffness = 0.0;  ///< k_n e_n^2, N/m

  static EnergyRestitutionLaw on_ground(double stiffness, const GroundParameters& ground) {
    return {stiffness, stiffness * ground.energy_restitution};
  }

  double static_stiffness() const { return unloading_stiffness; }
  double stored_energy(double overlap, double /*residual_indentation*/) const {
    return 0.5 * unloading_stiffness * overlap * overlap;
  }
  NormalForceState initial_state(double overlap, double /*rate*/, double /*effective_mass*/,
                                 double /*patch_force*/) const {
    return {unloading_stiffness * overlap, 0.0};
  }
  double highest_frequency(double frequency) const { return frequency; }
  double force_drop(double overlap, double force) const {
    return force - unloading_stiffness * overlap;
  }
  double unloading_ratio(double stiffness) const { return unloading_stiffness / stiffness; }

  NormalForceResponse integrate(const OverlapPath& path, const NormalForceState& state,
                                double /*effective_mass*/) const {
    double force = state.force;
    const double reversal_time = path.reversal_time();
    const bool growing =
        path.initial_rate > 0.0 || (path.initial_rate == 0.0 && path.quadratic_coefficient() > 0.0);
    if (reversal_time == path.duration && growing && path.initial_overlap >= 0.0) {
      const double deeper = path.final_overlap - path.initial_overlap;
      const double end = force + loading_stiffness * deeper;
      return {end, 0.5 * (force + end) * deeper, 0.0, 0.0};
    }
    const bool on_return_line = std::abs(force - unloading_stiffness * path.initial_overlap) <=
                                kUnloadingLineTolerance * force;
    if (reversal_time == path.duration && !growing && path.final_overlap >= 0.0 && on_return_line) {
      const double end = unloading_stiffness * path.final_overlap;
      return {end, 0.5 * (force + end) * (path.final_overlap - path.initial_overlap), 0.0, 0.0};
    }

    ForcePathIntegral integral(path, force);
    const auto returning = [&](double time) { return unloading_stiffness * path.overlap_at(time); };
    const auto follow = [&](double from, double to) {
      if (!(to > from)) return;
      const double first = path.overlap_at(from), last = path.overlap_at(to);
      if (last > first) {
        if (last <= 0.0) return;
        const double touch = first < 0.0 ? path.zero_crossing(from, to) : from;
        const double base = first < 0.0 ? 0.0 : force - loading_stiffness * first;
        const auto pressing = [&](double time) {
          return base + loading_stiffness * path.overlap_at(time);
        };
        integral.add_interval(touch, to, pressing);
        force = pressing(to);
      } else {
        if (first > 0.0) {
          integral.add_interval(from, last < 0.0 ? path.zero_crossing(from, to) : to, returning);
        }
        force = last > 0.0 ? returning(to) : 0.0;
      }
    };
    follow(0.0, reversal_time);
    follow(reversal_time, path.duration);
    return integral.response(force);
  }

 private:
  /// Tolerance for forces on the unloading line, relative to the force. Integration errors at a
  /// reversal shift the force off the line by less than this.
  static constexpr double kUnloadingLineTolerance = 1e-5;
};

}  // namespace clast
