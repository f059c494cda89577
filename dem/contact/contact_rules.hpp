#pragma once
/// What all contacts of a kind share: on the ground, between bodies, or on forms.
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/ground_parameters.hpp"
#include "dem/contact/soil_memory.hpp"

namespace clast::dem_detail {

class ContactRules {
 public:
  /// @param of_zones     parameters of each ground zone; these, `of_faces` and `remembering` must
  ///                     outlive the rules
  /// @param of_faces     zone of each face of the reference; empty: all are of zone 0
  /// @param remembering  dents of earlier contacts; null: none is remembered
  ContactRules(std::span<const GroundParameters> of_zones, std::span<const std::uint16_t> of_faces,
               const ContactStiffness& with_stiffness, ContactWeights with_weights,
               const ContactLaw& law, const SoilMemory* remembering = nullptr);

  std::uint16_t zone_of(std::uint32_t face) const {
    return zone_of_face.empty() ? std::uint16_t{0} : zone_of_face[face];
  }
  /// Calls `visit` with the laws of the zones, which are of one kind.
  template <class Visit>
  decltype(auto) with_laws(const Visit& visit) const {
    return std::visit([&](const auto& by_zone) -> decltype(auto) { return visit(by_zone.laws); },
                      laws_);
  }

  std::span<const GroundParameters> zones;
  std::span<const std::uint16_t> zone_of_face;
  ContactStiffness stiffness;
  ContactWeights weights;
  const SoilMemory* soil;
  double tangential_give;                     ///< 1/k_t
  std::vector<double> rolling, rolling_give;  ///< k_r and 1/k_r by zone
  std::vector<double> drag_strength;          ///< C_d rho/2 by zone, kg/m^3
  bool slip_grows = false;                    ///< friction grows with slip, on any zone
  bool drags = false;                         ///< any zone has a scar drag

 private:
  template <class Law>
  struct ByZone {
    std::vector<Law> laws;
  };
  template <class Choice>
  struct LawsOf;
  template <class... Laws>
  struct LawsOf<std::variant<Laws...>> {
    using Type = std::variant<ByZone<Laws>...>;
  };

  LawsOf<ContactLaw>::Type laws_;
};

}  // namespace clast::dem_detail
