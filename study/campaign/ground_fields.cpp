#include "study/campaign/ground_fields.hpp"

#include <array>

#include "study/campaign/campaign_ranges.hpp"

namespace clast {

using namespace study_detail;

std::span<const GroundParameterField> ground_parameter_fields() {
  using Parameters = GroundParameters;
  using Table = GroundDistributions;
  static constexpr std::array<GroundParameterField, 10> kFields{
      {{"energy_restitution", "", "e_n^2", "e_n\xC2\xB2", "energy restitution",
        kEnergyRestitutionRange, true, false, &Parameters::energy_restitution,
        &Table::energy_restitution},
       {"friction", "", "mu", "friction \xC2\xB5", "friction", kFrictionRange, true, false,
        &Parameters::friction, &Table::friction},
       {"rolling_friction", "", "mu_R", "rolling friction \xC2\xB5_R", "rolling friction",
        kFrictionRange, true, false, &Parameters::rolling_friction, &Table::rolling_friction},
       {"rolling_length_m", "m", "a, with k_r = k_n a^2; 0: not given", "rolling length a, m",
        "rolling length", kRollingLengthRange, false, false, &Parameters::rolling_length,
        &Table::rolling_length},
       {"friction_min", "", "smallest mu, before sliding, if mu grows with slip",
        "smallest friction \xC2\xB5", "smallest friction", kFrictionRange, false, true,
        &Parameters::friction_min, &Table::friction_min},
       {"slip_growth_per_m", "1/m", "kappa, growth of mu with slip; 0: mu is constant",
        "growth with slip \xCE\xBA, 1/m", "growth of friction with slip", kSlipGrowthRange, false,
        true, &Parameters::slip_growth, &Table::slip_growth},
       {"slip_memory_s", "s", "1/beta, decay time of the slip after a contact",
        "memory of slip 1/\xCE\xB2, s", "memory of slip", kSlipMemoryRange, false, true,
        &Parameters::slip_memory, &Table::slip_memory},
       {"scar_drag", "", "C_d of the scar drag; 0: no drag", "scar drag C_d", "scar drag",
        kScarDragRange, false, true, &Parameters::scar_drag, &Table::scar_drag},
       {"soil_density_kg_m3", "kg/m^3", "rho, density of the soil displaced by scar drag",
        "soil density \xCF\x81, kg/m\xC2\xB3", "soil density", kSoilDensityRange, false, true,
        &Parameters::soil_density, &Table::soil_density},
       {"soil_memory_m", "m", "width of cells that store residual indentation; 0: no cells",
        "cells of soil memory, m", "cells of soil memory", kSoilMemoryRange, false, true,
        &Parameters::soil_memory, &Table::soil_memory}}};
  return kFields;
}

std::string GroundParameterField::explanation() const {
  return (is_soil_parameter ? "experimental, unmeasured: " : "") + std::string(words) + ": " +
         meaning;
}

}  // namespace clast
