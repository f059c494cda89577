#include "dem/contact/contact_model.hpp"

namespace clast::dem_detail {

ContactModel::ContactModel(std::span<const GroundParameters> ground_parameters,
                           std::span<const std::uint16_t> face_zones,
                           const ContactStiffness& contact_stiffness,
                           ContactWeighting contact_weighting, const ContactLaw& law,
                           const SoilMemory* memory)
    : zone_parameters(ground_parameters),
      zone_of_face(face_zones),
      stiffness(contact_stiffness),
      weighting(contact_weighting),
      soil_memory(memory),
      tangential_compliance(1.0 / stiffness.tangential) {
  for (const GroundParameters& zone : zone_parameters) {
    has_slip_dependent_friction = has_slip_dependent_friction || zone.slip_growth > 0.0;
    rolling_stiffnesses.push_back(zone.rolling_stiffness(stiffness.normal, stiffness.rolling));
    rolling_compliances.push_back(1.0 / rolling_stiffnesses.back());
    drag_factors.push_back(0.5 * zone.scar_drag * zone.soil_density);
    has_scar_drag = has_scar_drag || drag_factors.back() > 0.0;
  }
  std::visit(
      [&]<NormalForceLaw Law>(const Law&) {
        ZoneLaws<Law> by_zone;
        for (const GroundParameters& zone : zone_parameters) {
          by_zone.laws.push_back(Law::on_ground(stiffness.normal, zone));
        }
        laws_ = std::move(by_zone);
      },
      law);
}

}  // namespace clast::dem_detail
