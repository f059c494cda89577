#pragma once
/// Choice of contact stiffness and time step.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast {

/// Values fixed by the user. Values left empty are chosen.
struct StiffnessOptions {
  std::optional<double> normal;      ///< k_n, N/m
  std::optional<double> tangential;  ///< k_t, N/m
  std::optional<double> rolling;     ///< k_r on ground without rolling length, N m/rad
  std::optional<double> time_step;   ///< s
  ContactLaw law;  ///< law that determines the settled depth and the fastest contact rate
  /// True for multi-block releases. Some impact is always in progress there, and only their sum
  /// matters. Steps are then twice as long (docs/theory.md, Steps of a world).
  bool multi_block = false;
};

/// Returns the mobility at each vertex, 1/kg: the largest acceleration of the surface point beyond
/// the vertex by a unit force there. It is the largest eigenvalue of 1/m + [x]^T J^-1 [x], with
/// mass m, inertia tensor J, and cross-product matrix [x] of the position from the centre.
std::vector<double> vertex_mobilities(const RigidBody& body);

/// Body properties that determine the stiffness.
struct BodyStiffnessInputs {
  double mass = 0.0;             ///< kg
  double smallest_side = 0.0;    ///< S, m
  double smallest_moment = 0.0;  ///< kg m^2
  double mobility = 0.0;         ///< largest mobility of any surface point, 1/kg
};
BodyStiffnessInputs body_stiffness_inputs(const RigidBody& body);

/// Most demanding properties of all ground zones under a law.
struct GroundStiffnessInputs {
  double static_stiffness_ratio = 1.0;      ///< static stiffness over k_n: e_n^2 or 1, by law
  double frequency_ratio = 1.0;             ///< fastest contact rate over the spring's frequency
  double rolling_length = 0.0;              ///< largest rolling length, m; 0 if no zone has one
  bool all_rolling_lengths_stated = true;   ///< true if no zone uses the k_r of the contacts
  double residual_indentation_ratio = 0.0;  ///< residual indentation over impact depth

  void include(
      const GroundStiffnessInputs& other);  ///< takes the more demanding value of each property
};
GroundStiffnessInputs ground_stiffness_inputs(std::span<const GroundParameters> zones,
                                              const ContactLaw& law);

/// Chosen stiffness, with warnings about values fixed by the user.
struct StiffnessChoice {
  ContactStiffness stiffness;
  /// Largest settled depth, m: m g over the static stiffness, which is k_n e_n^2 or k_n by law.
  /// Under plastic laws at least the residual indentation of the fastest impact.
  double settled_depth = 0.0;
  double impact_depth = 0.0;  ///< largest impact depth at the speed `max_speed`, m
  std::vector<std::string> warnings;
};

/// Chooses the contact stiffness and time step (docs/theory.md). S is the smallest side of a body.
///
/// - k_n: the settled depth is at most d = min(2 cm, 2 % of S) for all bodies and zones, such as
///   k_n = m g/(e_n^2 d) for energy restitution. An impact at `max_speed` is at most S/4 deep.
/// - k_t = k_n, or k_n/e_n^2 for plastic laws.
/// - k_r = k_t (S/2)^2 of the smallest body, for ground without rolling length.
/// - Time step: short enough for the fastest contact oscillation.
///
/// Touching bodies share one stiffness. Bodies that touch only the ground are passed alone.
/// @param fastest  upper bound of the speed of any block, from release and lowest heights, m/s
/// @throws SimulationError  if there are no bodies, or if the user's time step exceeds the
///                          stability limit or lets a body move by more than S/4 at `max_speed`
StiffnessChoice choose_stiffness(std::span<const BodyStiffnessInputs> bodies,
                                 const GroundStiffnessInputs& ground, double max_speed,
                                 double gravity, const StiffnessOptions& options = {});
StiffnessChoice choose_stiffness(std::span<const RigidBody> bodies,
                                 std::span<const GroundParameters> zones, double max_speed,
                                 double gravity, const StiffnessOptions& options = {});

}  // namespace clast
