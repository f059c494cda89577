#include "study/ground_fields.hpp"

#include <array>

#include "study/detail/campaign_ranges.hpp"

namespace clast {

using namespace study_detail;

std::span<const GroundField> ground_fields() {
  using Parameters = GroundParameters;
  static constexpr std::array<GroundField, 4> kFields{
      {{"energy_restitution", "", "e_n^2", "e_n\xC2\xB2", "energy restitution", kEnergyRestitution,
        true, &Parameters::energy_restitution, &GroundTable::energy_restitution},
       {"friction", "", "mu", "friction \xC2\xB5", "friction", kFriction, true,
        &Parameters::friction, &GroundTable::friction},
       {"rolling_friction", "", "mu_R", "rolling friction \xC2\xB5_R", "rolling friction",
        kFriction, true, &Parameters::rolling_friction, &GroundTable::rolling_friction},
       {"rolling_length_m", "m", "a, k_r = k_n a^2; 0: not stated", "rolling length a, m",
        "rolling length", kRollingLength, false, &Parameters::rolling_length,
        &GroundTable::rolling_length}}};
  return kFields;
}

}  // namespace clast
