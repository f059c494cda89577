#pragma once
/// Interface of normal force laws (docs/theory.md, Normal laws).
#include <concepts>

#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/overlap_path.hpp"

namespace clast {

/// Requirements on a law of the normal force at the contacts on one ground zone. The law holds its
/// coefficients; each contact holds its own state. Forces are per unit of contact weight, N;
/// overlaps and the residual indentation h_p are in metres.
///
/// - `kName`: its name in campaign files.
/// - `kNeedsEffectiveMass`: true if `integrate` uses the effective mass of the contact, kg.
/// - `kIsPlastic`: true if it leaves a residual indentation.
/// - `on_ground(k_n, ground)`: the law with the coefficients of a ground zone; k_n in N/m.
/// - `initial_state(overlap, rate, effective_mass, patch_force)`: the state of a contact that
///   begins with an overlap larger than its speed explains. `rate` is in m/s; `patch_force` is the
///   mean force of its contact patch, N.
/// - `integrate(path, state, effective_mass)`: the response to the overlap over a step.
/// - `stored_energy(overlap, h_p)`: elastic energy, J.
/// - `static_stiffness()`: force divided by overlap of a body at rest, N/m.
/// - `highest_frequency(w)`: the highest frequency or decay rate of a contact, rad/s, whose spring
///   alone has the angular frequency w. It limits the time step.
/// - `force_drop(overlap, force)`: by how much the force falls when loading turns to unloading, N.
/// - `unloading_ratio(k_n)`: unloading stiffness divided by k_n. It gives the returnable energy.
template <class Law>
concept NormalForceLaw = requires(const Law& law, const GroundParameters& ground,
                                  const OverlapPath& path, const NormalForceState& state,
                                  double x) {
  { Law::kName } -> std::convertible_to<const char*>;
  { Law::kNeedsEffectiveMass } -> std::convertible_to<bool>;
  { Law::kIsPlastic } -> std::convertible_to<bool>;
  { Law::on_ground(x, ground) } -> std::same_as<Law>;
  { law.initial_state(x, x, x, x) } -> std::same_as<NormalForceState>;
  { law.integrate(path, state, x) } -> std::same_as<NormalForceResponse>;
  { law.stored_energy(x, x) } -> std::same_as<double>;
  { law.static_stiffness() } -> std::same_as<double>;
  { law.highest_frequency(x) } -> std::same_as<double>;
  { law.force_drop(x, x) } -> std::same_as<double>;
  { law.unloading_ratio(x) } -> std::same_as<double>;
};

}  // namespace clast
