#pragma once
/// Settings that single releases and worlds of many bodies share.
#include <span>
#include <string>

#include "dem/contact/contact_law.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

/// Contacts, gravity, and when a body counts as being at rest.
struct MotionSettings {
  ContactStiffness stiffness;  ///< of all contacts
  ContactLaw law;              ///< likewise; energy-restitution unless chosen otherwise
  ContactWeighting weights = ContactWeighting::kPatch;
  double gravity = 9.81;        ///< m/s^2, along -z
  double rest_energy = 2e-4;    ///< J/kg: v^2/2 + w.J.w/(2 m) below this ...
  double rest_duration = 0.5;   ///< ... for so long, s, with a contact throughout, is rest
  double start_overlap = 1e-3;  ///< largest overlap that a body may start with, share of its S

  void check() const;  ///< throws InputError naming the field and its value
};

/// @throws SimulationError  a ground zone of the terrain has no parameters
void check_zones(const TerrainSurface& terrain, std::span<const GroundParameters> zones);

/// @param name  what starts there, for messages
/// @throws SimulationError  the place is not above or on the terrain
void check_start(const TerrainSurface& terrain, const Vec3& position, const std::string& name);

}  // namespace clast
