#pragma once
/// The constitutive law of the normal force, how it is shared among contact points, and its
/// stiffness.
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

/// The normal laws to choose from; friction and rolling resistance are the same under all of them.
/// Another law is one struct that is a `NormalLaw`, in a file of its own, named here.
template <NormalLaw... Laws>
using LawVariant = std::variant<Laws...>;
using ContactLaw = LawVariant<EnergyRestitutionLaw, SpringDashpotLaw, ElastoplasticLaw>;

/// A law by name, "energy-restitution", "spring-dashpot" or "elastoplastic".
/// @throws InputError  unknown name; the message lists the laws
ContactLaw parse_contact_law(const std::string& name);
std::string name_of(const ContactLaw& law);
/// Names of all laws, in the order of the variant.
std::vector<std::string> contact_law_names();

/// How contact stiffness is shared among the points of one block.
enum class ContactWeighting {
  kPatch,    ///< by overlap within each contact patch; each patch carries the law once
  kOverlap,  ///< by overlap among all points of the block (Eq. 8)
  kCount,    ///< equally among all points of the block (Eq. 7)
  kNone,     ///< every point carries the full stiffness
};

/// @throws InputError  unknown name; the message lists patch, overlap, count, none
ContactWeighting parse_contact_weighting(const std::string& name);
std::string name_of(ContactWeighting weights);

/// Stiffnesses and the time steps that they require.
struct ContactStiffness {
  double normal = 0.0;      ///< k_n, N/m
  double tangential = 0.0;  ///< k_t, N/m
  double rolling = 0.0;     ///< k_r on ground that states no rolling length, N m/rad
  double time_step = 0.0;   ///< resolves an impact, s
  /// Resolves what goes on between impacts, s: a contact of the block's most mobile point. Below
  /// `time_step`: all steps have that length.
  double max_time_step = 0.0;
};

}  // namespace clast
