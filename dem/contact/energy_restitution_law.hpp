#pragma once
/// Energy-restitution normal law: loading with k_n, unloading with k_n e_n^2. @cite garcia2022 (Eq.
/// 2)
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Normal force f on a ground zone: f += k_n dh for growing overlap h, otherwise f = k_n e_n^2 h.
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
  double stored_energy(double overlap, double /*dent*/) const {
    return 0.5 * unloading_stiffness * overlap * overlap;
  }
  NormalState initial_state(double overlap, double /*rate*/, double /*effective_mass*/,
                            double /*patch_force*/) const {
    return {unloading_stiffness * overlap, 0.0};
  }
  double highest_frequency(double frequency) const { return frequency; }
  double force_drop(double overlap, double force) const {
    return force - unloading_stiffness * overlap;
  }
  double unloading_ratio(double stiffness) const { return unloading_stiffness / stiffness; }

  NormalResponse integrate(const OverlapPath& path, const NormalState& state,
                           double /*effective_mass*/) const {
    double force = state.force;
    const double reversal_time = path.reversal_time();
    const bool growing =
        path.rate > 0.0 || (path.rate == 0.0 && path.quadratic_coefficient() > 0.0);
    if (reversal_time == path.duration && growing && path.before >= 0.0) {
      const double deeper = path.after - path.before;
      const double end = force + loading_stiffness * deeper;
      return {end, 0.5 * (force + end) * deeper, 0.0, 0.0};
    }
    const bool on_return_line =
        std::abs(force - unloading_stiffness * path.before) <= kOnLine * force;
    if (reversal_time == path.duration && !growing && path.after >= 0.0 && on_return_line) {
      const double end = unloading_stiffness * path.after;
      return {end, 0.5 * (force + end) * (path.after - path.before), 0.0, 0.0};
    }

    PathIntegral integral(path, force);
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
  /// Relative distance up to which a force counts as on the unloading line. The correction at a
  /// reversal shifts the force off this line by (w dt)^4/24; this must not cause an event.
  static constexpr double kOnLine = 1e-5;
};

}  // namespace clast
