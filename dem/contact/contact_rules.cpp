#include "dem/contact/contact_rules.hpp"

namespace clast::dem_detail {

ContactRules::ContactRules(std::span<const GroundParameters> of_zones,
                           std::span<const std::uint16_t> of_faces,
                           const ContactStiffness& with_stiffness, ContactWeights with_weights,
                           const ContactLaw& law, const SoilMemory* remembering)
    : zones(of_zones),
      zone_of_face(of_faces),
      stiffness(with_stiffness),
      weights(with_weights),
      soil(remembering),
      tangential_give(1.0 / stiffness.tangential) {
  for (const GroundParameters& zone : zones) {
    slip_grows = slip_grows || zone.slip_growth > 0.0;
    rolling.push_back(zone.rolling_stiffness(stiffness.normal, stiffness.rolling));
    rolling_give.push_back(1.0 / rolling.back());
    drag_strength.push_back(0.5 * zone.scar_drag * zone.soil_density);
    drags = drags || drag_strength.back() > 0.0;
  }
  std::visit(
      [&]<NormalLaw Law>(const Law&) {
        ByZone<Law> by_zone;
        for (const GroundParameters& zone : zones) {
          by_zone.laws.push_back(Law::on_ground(stiffness.normal, zone));
        }
        laws_ = std::move(by_zone);
      },
      law);
}

}  // namespace clast::dem_detail
