#pragma once
/// What a ground zone does to a block.
#include <string>

namespace clast {

/// Parameters of a ground zone. @cite garcia2022 (Table 2)
struct GroundParameters {
  double energy_restitution = 0.01;  ///< e_n^2, in (0, 1]
  double friction = 0.7;             ///< mu
  double rolling_friction = 0.0;     ///< mu_R
  /// a, m: rolling resistance winds up with k_r = k_n a^2, as on springs at the distance a before
  /// and behind the contact (docs/theory.md, Rolling length). 0: with the k_r of the contacts.
  double rolling_length = 0.0;

  /// k_r on this ground, N m/rad.
  /// @param normal   k_n, N/m
  /// @param without  k_r where the ground states no length, N m/rad
  double rolling_stiffness(double normal, double without) const {
    return rolling_length > 0.0 ? normal * rolling_length * rolling_length : without;
  }

  void check(const std::string& zone) const;  ///< throws InputError naming zone, field and value
};

}  // namespace clast
