#pragma once
/// Choice of contact stiffness and time step.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast {

/// Values fixed by the user; the others are chosen.
struct StiffnessOptions {
  std::optional<double> normal;      ///< k_n, N/m
  std::optional<double> tangential;  ///< k_t, N/m
  std::optional<double> rolling;     ///< k_r on ground without rolling length, N m/rad
  std::optional<double> time_step;   ///< s
  ContactLaw law;                    ///< determines the settled depth and the fastest contact rate
  /// True for multi-block releases, in which some impact is always in progress and all of them
  /// matter together. Steps are then twice as long (docs/theory.md, Steps of a world).
  bool multi_block = false;
};

/// Returns the mobility at each vertex: the largest eigenvalue of 1/m + [x]^T J^-1 [x] at the
/// surface point beyond the vertex, 1/kg.
std::vector<double> vertex_mobilities(const RigidBody& body);

/// Body properties that determine the stiffness.
struct BodyRequirements {
  double mass = 0.0;             ///< kg
  double smallest_side = 0.0;    ///< S, m
  double smallest_moment = 0.0;  ///< kg m^2
  double mobility = 0.0;         ///< largest of any surface point, 1/kg
};
BodyRequirements body_requirements(const RigidBody& body);

/// Properties of the most demanding ground zone under a law.
struct GroundRequirements {
  double static_stiffness_ratio = 1.0;      ///< static stiffness over k_n: e_n^2 or 1, by law
  double frequency_ratio = 1.0;             ///< fastest contact rate over the spring's frequency
  double rolling_length = 0.0;              ///< largest, m; 0: none
  bool all_rolling_lengths_stated = true;   ///< true if no zone uses the k_r of the contacts
  double residual_indentation_ratio = 0.0;  ///< residual indentation over impact depth, by law

  void include(
      const GroundRequirements& other);  ///< takes the more demanding value of each property
};
GroundRequirements ground_requirements(std::span<const GroundParameters> zones,
                                       const ContactLaw& law);

/// Chosen stiffness, with warnings about user-defined values.
struct StiffnessChoice {
  ContactStiffness stiffness;
  /// Largest settled depth, m: m g/(k_n e_n^2) or m g/k_n by law, or the residual indentation of
  /// the fastest impact.
  double settled_depth = 0.0;
  double impact_depth = 0.0;  ///< largest impact depth at the speed `fastest`, m
  std::vector<std::string> warnings;
};

/// Chooses k_n such that the settled depth is at most d = min(2 cm, 2 % of S): m g/(e_n^2 d) for
/// the energy-restitution law, the maximum over bodies and zones; stiffer if an impact at `fastest`
/// would exceed S/4. k_t = k_n, or k_n/e_n^2 for plastic laws; k_r = k_t (S/2)^2 of the smallest
/// body for ground without rolling length; the time step is below the fastest contact oscillation
/// (docs/theory.md). Bodies that touch each other share one stiffness; a body that touches only the
/// ground is passed alone.
/// @param fastest  speed that no block can exceed, from release heights and the lowest ground, m/s
/// @throws SimulationError  if there is nothing to choose for, or the user's time step exceeds the
///                          stability limit or a quarter of S at `fastest`
StiffnessChoice choose_stiffness(std::span<const BodyRequirements> bodies,
                                 const GroundRequirements& ground, double fastest, double gravity,
                                 const StiffnessOptions& options = {});
StiffnessChoice choose_stiffness(std::span<const RigidBody> bodies,
                                 std::span<const GroundParameters> zones, double fastest,
                                 double gravity, const StiffnessOptions& options = {});

}  // namespace clast
