#pragma once
/// Parameters of the contact law: loading with k_n, unloading with k_n e_n^2, Coulomb friction and
/// rolling resistance (Eqs. 2-5 of the paper). @cite garcia2022
#include <string>

namespace clast {

/// What a ground zone does to a block. @cite garcia2022 (Table 2)
struct GroundParameters {
  double energy_restitution = 0.01;  ///< e_n^2, in (0, 1]
  double friction = 0.7;             ///< mu
  double rolling_friction = 0.0;     ///< mu_R

  void check(const std::string& zone) const;  ///< throws InputError naming zone, field and value
};

/// How contact stiffness is shared among the points of one block.
enum class ContactWeights {
  kPatch,    ///< by overlap within each contact patch; a patch carries one law
  kOverlap,  ///< by overlap among all points of the block (Eq. 8)
  kCount,    ///< equally among all points of the block (Eq. 7)
  kNone,     ///< every point carries the full stiffness
};

/// @throws InputError  unknown name; the message lists patch, overlap, count, none
ContactWeights contact_weights(const std::string& name);
std::string name_of(ContactWeights weights);

/// Stiffnesses and the time step they ask for.
struct ContactStiffness {
  double normal = 0.0;      ///< k_n, N/m
  double tangential = 0.0;  ///< k_t, N/m
  double rolling = 0.0;     ///< k_r, N m/rad
  double time_step = 0.0;   ///< s
};

}  // namespace clast
