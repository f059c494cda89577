#pragma once
/// Choice of contact stiffness and time step.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast {

/// Contact stiffness and time step given by the user. Empty values are chosen automatically.
struct StiffnessOptions {
  std::optional<double> normal;      ///< normal stiffness k_n, N/m
  std::optional<double> tangential;  ///< tangential stiffness k_t, N/m
  /// Rolling stiffness k_r on ground without a rolling length, N m/rad.
  std::optional<double> rolling;
  std::optional<double> time_step;  ///< s
  ContactLaw law;                   ///< normal contact law
  /// True for releases of many blocks at once. Time steps are then twice as long, because only the
  /// sum of many impacts matters (docs/theory.md, Steps of a world).
  bool multi_block = false;
};

/// Returns the mobility (largest inverse effective mass) of a body at each of its vertices, 1/kg:
/// the largest acceleration that a unit force at the surface causes there.
std::vector<double> vertex_mobilities(const RigidBody& body);

/// Properties of a body that determine its contact stiffness.
struct BodyStiffnessInputs {
  double mass = 0.0;             ///< kg
  double smallest_side = 0.0;    ///< shortest side S of the smallest box, m
  double smallest_moment = 0.0;  ///< smallest principal moment of inertia, kg m^2
  double mobility = 0.0;         ///< largest inverse effective mass of any surface point, 1/kg
};
BodyStiffnessInputs body_stiffness_inputs(const RigidBody& body);

/// Properties of all ground zones that determine the contact stiffness. Each is the most demanding
/// value over the zones.
struct GroundStiffnessInputs {
  double static_stiffness_ratio = 1.0;  ///< static stiffness divided by normal stiffness
  /// Highest contact frequency divided by the frequency of the spring alone.
  double frequency_ratio = 1.0;
  double rolling_length = 0.0;              ///< largest rolling length, m; 0 if no zone has one
  bool all_rolling_lengths_stated = true;   ///< true if each zone has its own rolling length
  double residual_indentation_ratio = 0.0;  ///< residual indentation divided by impact depth

  /// Replaces each property by the more demanding value of both.
  void include(const GroundStiffnessInputs& other);
};
GroundStiffnessInputs ground_stiffness_inputs(std::span<const GroundParameters> zones,
                                              const ContactLaw& law);

/// Chosen contact stiffness, with warnings about values given by the user.
struct StiffnessChoice {
  ContactStiffness stiffness;
  /// Largest settled depth, m: weight of a body divided by the static contact stiffness. Under
  /// plastic laws, it is at least the residual indentation of the fastest impact.
  double settled_depth = 0.0;
  double impact_depth = 0.0;  ///< largest overlap of an impact at the largest possible speed, m
  std::vector<std::string> warnings;
};

/// Chooses the contact stiffness and time step (docs/theory.md). S is the smallest side of a body.
///
/// - Normal stiffness: the settled depth is at most 2 cm and 2 % of S for all bodies and zones. An
///   impact at `max_speed` is at most S/4 deep.
/// - Tangential stiffness: equal to the normal stiffness, or to the unloading stiffness of plastic
///   laws.
/// - Rolling stiffness on ground without rolling length: tangential stiffness times (S/2)^2 of the
///   smallest body.
/// - Time step: short enough for the fastest contact oscillation.
///
/// Bodies that can touch each other share one stiffness. For a body that touches only the ground,
/// pass that body alone.
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
