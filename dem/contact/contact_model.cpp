#include "dem/contact/contact_model.hpp"

namespace clast::dem_detail {

ContactModel::ContactModel(std::span<const GroundParameters> zone_parameters,
                           std::span<const std::uint16_t> face_zones,
                           const ContactStiffness& contact_stiffness, ContactWeighting weighting,
                           const ContactLaw& law, const SoilMemory* soil_memory)
    : zones(zone_parameters),
      zone_of_face(face_zones),
      stiffness(contact_stiffness),
      weights(weighting),
      soil(soil_memory),
      tangential_compliance(1.0 / stiffness.tangential) {
  for (const GroundParameters& zone : zones) {
    has_slip_dependent_friction = has_slip_dependent_friction || zone.slip_growth > 0.0;
    rolling.push_back(zone.rolling_stiffness(stiffness.normal, stiffness.rolling));
    rolling_compliance.push_back(1.0 / rolling.back());
    drag_factors.push_back(0.5 * zone.scar_drag * zone.soil_density);
    has_scar_drag = has_scar_drag || drag_factors.back() > 0.0;
  }
  std::visit(
      [&]<NormalLaw Law>(const Law&) {
        ZoneLaws<Law> by_zone;
        for (const GroundParameters& zone : zones) {
          by_zone.laws.push_back(Law::on_ground(stiffness.normal, zone));
        }
        laws_ = std::move(by_zone);
      },
      law);
}

}  // namespace clast::dem_detail
