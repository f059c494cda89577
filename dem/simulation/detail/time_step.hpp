#pragma once
/// Time step of single releases and worlds (docs/theory.md, Time step).
#include <span>

#include "dem/simulation/detail/contact_pair_table.hpp"
#include "dem/simulation/world.hpp"

namespace clast::dem_detail {

/// Contacts are an impact if they transfer more than this fraction of a body's kinetic energy.
inline constexpr double kImpactFraction = 0.01;
/// Largest step divided by `max_time_step`, for contacts at points of low mobility.
inline constexpr double kMaxStepGrowth = 2.0;
/// Largest energy of a rocking stationary block, as a multiple of the rest energy.
inline constexpr double kRockingEnergyFactor = 10.0;

/// True if steps between impacts may be longer than steps that resolve an impact.
inline bool allows_longer_steps(const ContactStiffness& contact) {
  return contact.max_time_step >= contact.time_step;
}

/// True if more than a small fraction of the kinetic energy passes through the contacts.
/// @param transferred_energy, kinetic  both in J or both in J/kg
inline bool is_impact(double transferred_energy, double kinetic) {
  return transferred_energy > kImpactFraction * kinetic;
}

/// Returns the time step of a single release if longer steps are allowed, s. It follows from the
/// stiffness of all contacts; during an impact it is at most `time_step`.
/// @param mobility_ratio  mobility of the body at its contacts over its largest vertex mobility
double contact_time_step(const ContactStiffness& contact, double mobility_ratio, bool impact);

struct TimeStep {
  double length = 0.0;  ///< s
  bool flight = false;  ///< true if no contact exists, and none is possible before the step ends
};

/// Chooses the longest step that the contacts of all moving bodies allow. It is `time_step` during
/// an impact, before a possible impact, and if longer steps are disabled.
/// @param moving  indices of the moving bodies
/// @param pairs  pairs with an up-to-date active list
TimeStep choose_time_step(std::span<const WorldBody> bodies, std::span<const std::uint32_t> moving,
                          const ContactPairTable& pairs, const WorldSettings& settings);

}  // namespace clast::dem_detail
