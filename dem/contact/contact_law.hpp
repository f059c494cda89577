#pragma once
/// Normal contact laws, contact weighting, and stiffness.
/// @cite garcia2022
#include <string>
#include <variant>
#include <vector>

#include "dem/contact/elastoplastic_law.hpp"
#include "dem/contact/energy_restitution_law.hpp"
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/normal_law.hpp"
#include "dem/contact/spring_dashpot_law.hpp"

namespace clast {

/// Variant of the available normal contact laws. Friction and rolling resistance are the same under
/// all of them. A new law is a struct that satisfies `NormalForceLaw` and is listed here.
template <NormalForceLaw... Laws>
using LawVariant = std::variant<Laws...>;
using ContactLaw = LawVariant<EnergyRestitutionLaw, SpringDashpotLaw, ElastoplasticLaw>;

/// Parses the name of a law: "energy-restitution", "spring-dashpot" or "elastoplastic".
/// @throws InputError  if the name is unknown; the message lists the laws
ContactLaw parse_contact_law(const std::string& name);
std::string name_of(const ContactLaw& law);
/// Returns the names of all normal contact laws, such as "elastoplastic".
std::vector<std::string> contact_law_names();

/// Distribution of the contact stiffness over the contact points of a block.
enum class ContactWeighting {
  kPatch,    ///< proportional to overlap within each contact patch; the weights of a patch sum to 1
  kOverlap,  ///< proportional to overlap over all points of the block (Eq. 8)
  kCount,    ///< equal for all points of the block (Eq. 7)
  kNone,     ///< each point has the full stiffness
};

/// Parses the name of a contact weighting: "patch", "overlap", "count" or "none".
/// @throws InputError  if the name is unknown; the message lists all names
ContactWeighting parse_contact_weighting(const std::string& name);
std::string name_of(ContactWeighting weighting);

/// Contact stiffness and the time steps that it requires.
struct ContactStiffness {
  double normal = 0.0;      ///< normal stiffness k_n, N/m
  double tangential = 0.0;  ///< tangential stiffness k_t, N/m
  double rolling = 0.0;     ///< rolling stiffness k_r on ground without a rolling length, N m/rad
  double time_step = 0.0;   ///< time step that resolves an impact, s
  /// Time step between impacts, s. It is stable for a contact at the point of the block with the
  /// smallest effective mass. If it is below `time_step`, all steps have the length `time_step`.
  double max_time_step = 0.0;
};

}  // namespace clast
