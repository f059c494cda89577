#pragma once
/// Settings that single releases and worlds of many bodies share.
#include <span>
#include <string>

#include "dem/contact/contact_law.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

/// Settings of a motion: contact parameters, gravity and rest criterion.
struct MotionSettings {
  ContactStiffness stiffness;  ///< stiffness of all contacts
  ContactLaw law;              ///< normal law of all contacts; default: energy-restitution
  ContactWeighting weighting = ContactWeighting::kPatch;
  double gravity = 9.81;      ///< acceleration of gravity along -z, m/s^2
  double rest_energy = 2e-4;  ///< largest kinetic energy per mass of a body at rest, J/kg
  /// Time for which a body at rest must have been slow and in contact, s.
  double rest_duration = 0.5;
  double start_overlap = 1e-3;  ///< maximum initial overlap, as a fraction of the smallest side S

  void check() const;  ///< throws InputError naming the field and its value
};

/// Checks that all ground zones have parameters.
/// @throws SimulationError  if a zone has no parameters
void check_zone_parameters(const TerrainSurface& terrain, std::span<const GroundParameters> zones);

/// Checks that a start position is on or above the terrain.
/// @param name  of the starting body, for messages
/// @throws SimulationError  if the position is neither above nor on the terrain
void check_start_position(const TerrainSurface& terrain, const Vec3& position,
                          const std::string& name);

}  // namespace clast
