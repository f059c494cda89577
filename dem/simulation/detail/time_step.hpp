#pragma once
/// How long the next step of a single release or of a world may be (docs/theory.md, Time step).
#include <span>

#include "dem/simulation/detail/contact_pairs.hpp"
#include "dem/simulation/world.hpp"

namespace clast::dem_detail {

/// Contacts that more than this share of a body's kinetic energy passes through are an impact.
inline constexpr double kImpactShare = 0.01;
/// Contacts on points that are hard to move allow steps up to this many times `longest_step`.
inline constexpr double kHardlyMobile = 2.0;
/// A block whose mean place stays may rock with so many times the energy below which it rests.
inline constexpr double kRocking = 10.0;

/// True if steps between impacts may be longer than those that resolve an impact.
inline bool has_longer_steps(const ContactStiffness& contact) {
  return contact.longest_step >= contact.time_step;
}

/// True if more than a small share of the kinetic energy passes through the contacts.
/// @param through, kinetic  both in J, or both in J/kg
inline bool is_impact(double through, double kinetic) { return through > kImpactShare * kinetic; }

/// The step of a single release with longer steps, s: it follows the frequency of all contacts
/// together, and resolves an impact.
/// @param stiffer  mobility of the body at its contacts over its largest, `vertex_mobilities`
double step_of_contacts(const ContactStiffness& contact, double stiffer, bool impact);

struct StepChoice {
  double length = 0.0;  ///< s
  bool flight = false;  ///< nothing touches, nor can it before the step ends
};

/// As long as the contacts of all bodies that are not idle allow: `time_step` while one of them is
/// in an impact, and before one may begin. Without longer steps in the settings it is `time_step`
/// throughout.
/// @param moving  numbers of the bodies that are not idle
/// @param pairs   up to date, and so is the list of the active ones
StepChoice choose_step(std::span<const WorldBody> bodies, std::span<const std::uint32_t> moving,
                       const ContactPairs& pairs, const WorldSettings& settings);

}  // namespace clast::dem_detail
