#include "dem/contact/spring_dashpot_law.hpp"

namespace clast {
namespace {

/// Number of bisections that locate an event in a step to rounding.
constexpr int kBisections = 50;

/// Returns -ln(e_n) for a damping ratio.
double decay(double ratio) {
  if (ratio < 1.0) {
    const double theta = std::acos(ratio);
    return theta > 1e-6 ? 2.0 * theta / std::tan(theta) : 2.0;
  }
  const double eta = std::acosh(ratio);
  return eta > 1e-6 ? 2.0 * eta / std::tanh(eta) : 2.0;
}

}  // namespace

double damping_ratio_for_restitution(double energy_restitution) {
  const double wanted = -0.5 * std::log(energy_restitution);
  // The decay grows with the ratio, and a ratio of exp(decay / 2) is always enough.
  double low = 0.0, high = std::exp(0.5 * wanted);
  while (high - low > 1e-16 * high) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (decay(middle) < wanted ? low : high) = middle;
  }
  return energy_restitution < 1.0 ? 0.5 * (low + high) : 0.0;
}

SpringDashpotLaw SpringDashpotLaw::on_ground(double stiffness, const GroundParameters& ground) {
  return {stiffness, clast::damping_ratio_for_restitution(ground.energy_restitution)};
}

double SpringDashpotLaw::highest_frequency(double frequency) const {
  const double over = damping_ratio * damping_ratio - 1.0;
  return frequency * (over > 0.0 ? damping_ratio + std::sqrt(over) : 1.0);
}

NormalForceResponse SpringDashpotLaw::integrate(const OverlapPath& path,
                                                const NormalForceState& state,
                                                double effective_mass) const {
  const double force = state.force;
  const double c = damping_coefficient(effective_mass);
  const double step = path.duration;
  const auto law = [&](double time) {
    return stiffness * path.overlap_at(time) + c * path.rate_at(time);
  };
  const double end = path.final_overlap > 0.0 ? law(step) : 0.0;
  if (force > 0.0 && end > 0.0) {
    // No event: the work is that along the parabola, the impulse that of the Verlet step.
    ForcePathIntegral integral(path, force);
    integral.add_interval(0.0, step, law);
    return {end, integral.response(end).work, 0.0, 0.0};
  }

  ForcePathIntegral integral(path, force);
  if (path.initial_overlap <= 0.0 && path.final_overlap > 0.0 && force == 0.0) {
    // The contact starts inside the step. The path does not yet include the braking by the dashpot.
    const double touch =
        path.zero_crossing(path.reversal_time() < step ? path.reversal_time() : 0.0, step);
    const double rate = path.rate_at(touch);
    const double brake = c / effective_mass;
    const auto braked = [&](double time) {
      const double since = time - touch;
      return std::max(
          0.0, stiffness * path.overlap_at(time) + c * (path.rate_at(time) - brake * rate * since));
    };
    integral.add_interval(touch, step, braked);
    return integral.response(braked(step));
  }
  // The force ends or begins inside the step. It is a parabola in time, integrated in pieces.
  const double reversal_time = path.reversal_time();
  const auto follow = [&](double from, double to) {
    if (!(to > from)) return;
    const double first = law(from), last = law(to);
    if (first <= 0.0 && last <= 0.0) return;
    if (first > 0.0 && last > 0.0) {
      integral.add_interval(from, to, law);
      return;
    }
    double pressing = first > 0.0 ? from : to, slack = first > 0.0 ? to : from;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (pressing + slack);
      (law(middle) > 0.0 ? pressing : slack) = middle;
    }
    first > 0.0 ? integral.add_interval(from, pressing, law)
                : integral.add_interval(pressing, to, law);
  };
  follow(0.0, reversal_time);
  follow(reversal_time, step);
  return integral.response(std::max(0.0, end));
}

}  // namespace clast
