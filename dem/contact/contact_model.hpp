#pragma once
/// Contact parameters shared by all contacts on the ground, between bodies, or on confining walls.
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/soil_memory.hpp"

namespace clast::dem_detail {

class ContactModel {
 public:
  /// Makes the contact laws of all ground zones.
  /// @param ground_parameters  parameters of each ground zone; must outlive the model, as must
  ///                           `face_zones` and `memory`
  /// @param face_zones  ground zone of each face of the reference body; if empty, all faces are in
  ///                    zone 0
  /// @param memory  residual indentations of earlier contacts; null if there are none
  ContactModel(std::span<const GroundParameters> ground_parameters,
               std::span<const std::uint16_t> face_zones, const ContactStiffness& contact_stiffness,
               ContactWeighting contact_weighting, const ContactLaw& law,
               const SoilMemory* memory = nullptr);

  std::uint16_t zone_of(std::uint32_t face) const {
    return zone_of_face.empty() ? std::uint16_t{0} : zone_of_face[face];
  }
  /// Calls `visit` with the list of the zones' laws, which all have the same type.
  template <class Visit>
  decltype(auto) visit_laws(const Visit& visit) const {
    return std::visit([&](const auto& by_zone) -> decltype(auto) { return visit(by_zone.laws); },
                      laws_);
  }

  std::span<const GroundParameters> zone_parameters;
  std::span<const std::uint16_t> zone_of_face;
  ContactStiffness stiffness;
  ContactWeighting weighting;
  const SoilMemory* soil_memory;
  double tangential_compliance;  ///< inverse of the tangential stiffness, 1/k_t
  std::vector<double> rolling_stiffnesses,
      rolling_compliances;  ///< rolling stiffness k_r of each zone, and its inverse
  /// Half the product of drag coefficient and soil density of each zone, kg/m^3.
  std::vector<double> drag_factors;
  bool has_slip_dependent_friction =
      false;                   ///< true if friction depends on the slip distance in any zone
  bool has_scar_drag = false;  ///< true if any zone has scar drag

 private:
  template <class Law>
  struct ZoneLaws {
    std::vector<Law> laws;
  };
  template <class Choice>
  struct ZoneLawsOf;
  template <class... Laws>
  struct ZoneLawsOf<std::variant<Laws...>> {
    using Type = std::variant<ZoneLaws<Laws>...>;
  };

  ZoneLawsOf<ContactLaw>::Type laws_;
};

}  // namespace clast::dem_detail
