#pragma once
/// Stiffness and time step from what the contacts must do.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast {

/// What the user fixed; the rest follows.
struct StiffnessOptions {
  std::optional<double> normal;      ///< k_n, N/m
  std::optional<double> tangential;  ///< k_t, N/m
  std::optional<double> rolling;     ///< k_r on ground that states no rolling length, N m/rad
  std::optional<double> time_step;   ///< s
  ContactLaw law;                    ///< sets the settled depth and the fastest rate of a contact
  /// Of a mass: some impact is always going on, and what counts is all of them together. Steps in
  /// them are twice as long (docs/theory.md, Steps of a world).
  bool multi_block = false;
};

/// How easily a force at the surface beyond each vertex of the body moves it there: the largest
/// eigenvalue of the mobility 1/m + [x]^T J^-1 [x], 1/kg.
std::vector<double> vertex_mobilities(const RigidBody& body);

/// What a body requires of its contacts, computed once: the mobility needs all its points.
struct BodyRequirements {
  double mass = 0.0;             ///< kg
  double smallest_side = 0.0;    ///< S, m
  double smallest_moment = 0.0;  ///< kg m^2
  double mobility = 0.0;         ///< largest of any point of the surface, 1/kg
};
BodyRequirements body_requirements(const RigidBody& body);

/// What the most demanding ground zone requires under a law.
struct GroundRequirements {
  double static_stiffness_ratio = 1.0;  ///< of k_n that carries a body at rest: e_n^2, or 1 by law
  double frequency_ratio = 1.0;         ///< fastest rate of a contact over its spring's frequency
  double rolling_length = 0.0;          ///< largest stated, m; 0: none
  bool all_rolling_lengths_stated = true;   ///< no zone has the k_r of the contacts
  double residual_indentation_ratio = 0.0;  ///< of the depth of an impact that stays, by law

  void include(const GroundRequirements& other);  ///< the more demanding of both in every respect
};
GroundRequirements ground_requirements(std::span<const GroundParameters> zones,
                                       const ContactLaw& law);

/// A choice of stiffness, with warnings about what a user's own value leads to.
struct StiffnessChoice {
  ContactStiffness stiffness;
  /// Deepest settled depth, m: m g/(k_n e_n^2) or m g/k_n by law, or the dent of the fastest
  /// impact.
  double settled_depth = 0.0;
  double impact_depth = 0.0;  ///< deepest of an impact at `fastest` over bodies, m
  std::vector<std::string> warnings;
};

/// k_n such that a body rests no deeper than d = min(2 cm, 2 % of S), m g/(e_n^2 d) under the
/// energy-restitution law, largest over all bodies and zones; stiffer where an impact at `fastest`
/// would go deeper than S/4. k_t = k_n, or k_n/e_n^2 where dents stay; k_r = k_t (S/2)^2 of the
/// smallest body where the ground states no rolling length; a time step below the fastest contact
/// oscillation (docs/theory.md). Bodies that touch each other share one stiffness; one that touches
/// only ground is passed alone, so that its stiffness does not depend on others.
/// @param fastest  speed no block can exceed: from release heights and the lowest ground, m/s
/// @throws SimulationError  nothing to choose for, or a time step of the user's beyond the limit of
///                          stability or a quarter of S at `fastest`
StiffnessChoice choose_stiffness(std::span<const BodyRequirements> bodies,
                                 const GroundRequirements& ground, double fastest, double gravity,
                                 const StiffnessOptions& options = {});
StiffnessChoice choose_stiffness(std::span<const RigidBody> bodies,
                                 std::span<const GroundParameters> zones, double fastest,
                                 double gravity, const StiffnessOptions& options = {});

}  // namespace clast
