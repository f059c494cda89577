#pragma once
/// Time step of single releases and worlds (docs/theory.md, Time step).
#include <span>

#include "dem/simulation/detail/contact_pair_table.hpp"
#include "dem/simulation/world.hpp"

namespace clast::dem_detail {

/// Fraction of the kinetic energy of a body above which an energy transfer counts as impact.
inline constexpr double kImpactFraction = 0.01;
/// Ratio of the longest time step between impacts to `ContactStiffness::max_time_step`.
inline constexpr double kMaxStepGrowth = 2.0;
/// Largest kinetic energy of a block that rocks in place, as a multiple of the rest energy.
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

/// Returns the time step of a single release, s, if steps between impacts may be longer. During an
/// impact, it is at most `ContactStiffness::time_step`.
/// @param mobility_ratio  inverse effective mass of the body at its contacts, divided by the
///                        largest one of its vertices
double contact_time_step(const ContactStiffness& contact, double mobility_ratio, bool impact);

struct TimeStep {
  double length = 0.0;  ///< s
  bool flight = false;  ///< true if no contact exists, and none is possible before the step ends
};

/// Chooses the longest time step that the contacts of all moving bodies allow.
/// @param moving  indices of the moving bodies
/// @param pairs  pairs with an up-to-date active list
TimeStep choose_time_step(std::span<const WorldBody> bodies, std::span<const std::uint32_t> moving,
                          const ContactPairTable& pairs, const WorldSettings& settings);

}  // namespace clast::dem_detail
