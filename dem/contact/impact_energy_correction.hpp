#pragma once
/// Energy correction of impacts on ground of high restitution.
#include <optional>

#include "dem/contact/contact_forces.hpp"
#include "dem/motion/rigid_body_integrator.hpp"

namespace clast::dem_detail {

/// Scales the impulse of each impact so that the impact returns the energy that the law states.
///
/// Forces weighted by overlap are not conservative. A block that lands on several points and leaves
/// them one after the other gets back more or less energy than it gave (docs/theory.md, Weights and
/// energy). If the ground returns more than half of the energy, an impact could accelerate the
/// block. Therefore the total impulse is scaled at the end of the impact.
/// @cite stronge1990
class ImpactEnergyCorrection {
 public:
  /// True if impacts on this ground are corrected. The limit follows from the worst case: five
  /// points loaded together and unloaded one by one return twice the energy of the law.
  static bool applies_to(const GroundParameters& zone) { return zone.energy_restitution > 0.5; }

  /// Starts the energy correction of a run.
  /// @param energy  energy of the block at the start of the run, J
  explicit ImpactEnergyCorrection(double energy) : expected_energy_(energy) {}

  /// Records that the block touches a ground zone in the present impact.
  void add_touched_zone(const GroundParameters& zone) { applies_ = applies_ || applies_to(zone); }
  void add_contact_load(double duration, const ContactLoad& load);
  void add_correction_impulse(const CorrectionImpulse& event);

  /// Ends an impact after the block has left the ground. Corrects the velocities of the block if
  /// necessary.
  /// @param energy_plus_losses  energy of the block plus all dissipation since the start, J
  /// @returns true if the impact was corrected
  bool end_impact(RigidBodyIntegrator& body, double energy_plus_losses);
  /// Returns the sum of energy and dissipation expected at the end of a corrected impact, J; empty
  /// if the present impact is not corrected.
  std::optional<double> expected_energy() const {
    return applies_ ? std::optional(expected_energy_) : std::nullopt;
  }

  /// Impulse of all contacts in this impact, N s.
 private:
  Vec3 impulse_ = Vec3::Zero();
  Vec3 angular_impulse_ =
      Vec3::Zero();         ///< angular impulse in this impact about the centre of mass, N m s
  bool applies_ = false;    ///< true if this impact touches ground to which the correction applies
  double expected_energy_;  ///< energy of the block plus dissipation if no energy is reassigned, J
};

}  // namespace clast::dem_detail
