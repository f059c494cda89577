#pragma once
/// The energy balance of impacts on ground that returns most of what it takes.
#include <optional>

#include "dem/contact/contact_forces.hpp"
#include "dem/motion/rigid_body_integrator.hpp"

namespace clast::dem_detail {

/// Scales the impulses of impacts until they return the energy that the law states.
///
/// Forces that are shared by overlap have no potential: a block that lands on several points and
/// leaves from one after the other gets back more than it gave, or less (docs/theory.md, Weights
/// and energy). Where the ground returns more than half, an impact could leave a block faster than
/// it came. There, at the end of each impact, its whole impulse is scaled.
/// @cite stronge1990
class ImpactEnergyCorrection {
 public:
  /// True for ground whose impacts are balanced: five points loaded together and unloaded one after
  /// the other return twice what they took.
  static bool applies_to(const GroundParameters& zone) { return zone.energy_restitution > 0.5; }

  /// @param energy  of the block as the run begins, J
  explicit ImpactEnergyCorrection(double energy) : expected_energy_(energy) {}

  /// Notes the ground that the block touches.
  void add_touched_zone(const GroundParameters& zone) { applies_ = applies_ || applies_to(zone); }
  /// Adds the impulse of contact loads.
  void add_contact_load(double duration, const ContactLoad& load);
  void add_event_impulse(const EventImpulse& event);

  /// Ends an impact, when the block has left the ground. If the impact is balanced, it corrects the
  /// velocities of the block.
  /// @param accounted  energy of the block plus all that the law has dissipated since the run
  /// began,
  ///                   J
  /// @returns  true if the impact was balanced
  bool end_impact(RigidBodyIntegrator& body, double accounted);
  /// Within an impact that will be balanced: what will be accounted for when it has ended, J.
  std::optional<double> expected_energy() const {
    return applies_ ? std::optional(expected_energy_) : std::nullopt;
  }

 private:
  Vec3 impulse_ = Vec3::Zero();          ///< of all contacts in this impact, N s
  Vec3 angular_impulse_ = Vec3::Zero();  ///< about the centre of mass, N m s
  bool applies_ = false;                 ///< it touches ground for that
  double expected_energy_;               ///< what is accounted for where nothing is reassigned, J
};

}  // namespace clast::dem_detail
