#pragma once
/// How long the next step of a single release or of a world may be (docs/theory.md, Time step).
#include <span>

#include "dem/simulation/detail/contact_pair_table.hpp"
#include "dem/simulation/world.hpp"

namespace clast::dem_detail {

/// Contacts that more than this share of a body's kinetic energy passes through are an impact.
inline constexpr double kImpactFraction = 0.01;
/// Contacts on points that are hard to move allow steps up to this many times `max_time_step`.
inline constexpr double kMaxStepGrowth = 2.0;
/// A block whose mean place stays may rock with so many times the energy below which it rests.
inline constexpr double kRockingEnergyFactor = 10.0;

/// True if steps between impacts may be longer than those that resolve an impact.
inline bool allows_longer_steps(const ContactStiffness& contact) {
  return contact.max_time_step >= contact.time_step;
}

/// True if more than a small share of the kinetic energy passes through the contacts.
/// @param through, kinetic  both in J, or both in J/kg
inline bool is_impact(double transferred_energy, double kinetic) {
  return transferred_energy > kImpactFraction * kinetic;
}

/// The step of a single release with longer steps, s: it follows the frequency of all contacts
/// together, and resolves an impact.
/// @param stiffer  mobility of the body at its contacts over its largest, `vertex_mobilities`
double contact_time_step(const ContactStiffness& contact, double mobility_ratio, bool impact);

struct TimeStep {
  double length = 0.0;  ///< s
  bool flight = false;  ///< nothing touches, nor can it before the step ends
};

/// As long as the contacts of all bodies that are not idle allow: `time_step` while one of them is
/// in an impact, and before one may begin. Without longer steps in the settings it is `time_step`
/// throughout.
/// @param moving  numbers of the bodies that are not idle
/// @param pairs   up to date, and so is the list of the active ones
TimeStep choose_time_step(std::span<const WorldBody> bodies, std::span<const std::uint32_t> moving,
                          const ContactPairTable& pairs, const WorldSettings& settings);

}  // namespace clast::dem_detail
