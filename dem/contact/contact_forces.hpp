#pragma once
/// Forces of the contact points of one pair of bodies by Eqs. 2-8 of the paper: normal force,
/// friction and rolling resistance of each, shared out within the contact patches.
/// @cite garcia2022
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/contact/contact_model.hpp"
#include "dem/contact/energy_balance.hpp"
#include "dem/contact/scar_drag.hpp"
#include "dem/motion/body_motion.hpp"

namespace clast::dem_detail {

/// What contacts that begin, reverse or end inside a step add to it, in world axes.
struct EventImpulse {
  Vec3 impulse = Vec3::Zero();          ///< on the block, N s
  Vec3 angular_impulse = Vec3::Zero();  ///< about its centre of mass, N m s
  Vec3 angular_impulse_on_other = Vec3::Zero();
  // Only against what does not move; zero between two moving bodies.
  Vec3 moment = Vec3::Zero();          ///< mass times shift of the centre, N s^2
  Vec3 angular_moment = Vec3::Zero();  ///< inertia times turn, N m s^2

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(impulse, angular_impulse, angular_impulse_on_other, moment, angular_moment);
  }
};

/// What the contacts of a pair do to its bodies, in world axes. The other body gets -force.
struct ContactLoad {
  Vec3 force = Vec3::Zero();            ///< on the block
  Vec3 torque = Vec3::Zero();           ///< on the block about its centre of mass
  Vec3 torque_on_other = Vec3::Zero();  ///< on the other body about its own
  /// Energy that the contacts are about to take up, are giving back, or will drop when they turn,
  /// per mass of the block, J/kg (docs/theory.md, Time step).
  double impact = 0.0;
  /// To be applied once, at the end of this step (`RigidBodyIntegrator::apply_event_impulse`).
  std::unique_ptr<EventImpulse> event;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(force, torque, torque_on_other, impact, event);
  }
};

/// The contacts of a block with the ground, or with another block, over time: matched with those of
/// the step before, weighted within their patches, loaded by the constitutive law.
class ContactForces {
 public:
  /// @param rules  they and the block must outlive the forces
  /// @param size   smallest side of the block, m
  ContactForces(const ContactModel& model, const BlockSurface& block, double size);

  /// Loads at the present contacts after a step of `duration`. Books every joule of the step in
  /// `energy_balance`.
  /// @param points  in world axes
  /// @param other   the ground does not move
  ContactLoad update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                     const BodyMotion& other, double duration, EnergyBalance& energy_balance);

  /// Presses the dents of the present contacts into `soil`.
  void store_indentations(SoilMemory& soil) const;

  /// Time that has passed without contact and without an `update`, s.
  void advance_time(double duration) { contactless_time_ += duration; }

  bool empty() const { return contacts_.empty(); }
  std::size_t count() const { return contacts_.size(); }
  /// Of all contacts together, 1/kg: with springs of stiffness k at each, weighted, the block has
  /// no frequency above the root of k times this.
  /// @param vertex_mobilities  of the block (`vertex_mobilities`)
  double contact_mobility(std::span<const double> vertex_mobilities) const;
  /// Sum of the weights of all contacts.
  double weight() const;
  double stored_energy() const;  ///< what unloading would give back, J
  double max_overlap() const { return contacts_.empty() ? 0.0 : contacts_[deepest_].point.overlap; }
  struct DeepestContact {
    std::uint32_t contact_count = 0;  ///< all there are
    double overlap = 0.0;             ///< m
    Vec3 position = Vec3::Zero();
    std::uint16_t zone = 0;
  };
  /// The contact with the largest overlap; none without contacts.
  std::optional<DeepestContact> deepest_contact() const;
  /// Deepest of the patches that carry the block, vertically, m: a wedge between steep walls is
  /// tight but not deep.
  double settled_depth();
  /// Whether the law leaves dents: then impacts decide how deep a body rests, not its weight.
  bool is_plastic() const;
  /// Smallest stiffness with which a present contact carries a body at rest; k_n without any, N/m.
  double static_stiffness() const;

  /// All that the loads to come depend on.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patches_, contacts_, deepest_, last_wrench_, slip_, slipped_, contactless_time_);
    if (drag_) bytes(*drag_);
  }

 private:
  /// What the unit force of one patch does through all its points.
  struct PatchWrench {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    Vec3 torque_on_other = Vec3::Zero();
  };

  /// What all contacts together did at the end of the last step, in world axes: `force` on the
  /// block and the opposite on the other body.
  struct PairWrench {
    PairWrench() = default;
    PairWrench(const ContactLoad& load, const RelativeMotion& motion);
    /// Power that it takes from the bodies in their mean motion over the step that it ends, W ...
    double power_over_previous_step(const RelativeMotion& motion) const;
    /// ... and over the one that it begins.
    double power_over_next_step(const RelativeMotion& motion) const;

    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();           ///< on the block about its centre of mass
    Vec3 torque_on_other = Vec3::Zero();  ///< the opposite of that on the other body, about its own
    Vec3 centre = Vec3::Zero(), centre_of_other = Vec3::Zero();

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(force, torque, torque_on_other, centre, centre_of_other);
    }
  };

  /// Of one update, shared by all pairs of a thread.
  struct Scratch {
    std::vector<Contact> now;
    ContactHistory history;
    std::vector<PatchWrench> patch_wrenches;
  };
  static Scratch& scratch();

  template <NormalLaw Law>
  ContactLoad apply_law(const std::vector<Law>& laws, const std::vector<ContactPoint>& points,
                        const RelativeMotion& motion, Scratch& scratch,
                        EnergyBalance& energy_balance);
  /// Forgets the slip of earlier contacts as the ground that is touched now does.
  void decay_slip(std::uint16_t zone);
  /// Adds how far the block slid in this step, mean over its contacts.
  void accumulate_slip();
  void add_drag(const RelativeMotion& motion, ContactLoad& load, EnergyBalance& energy_balance);
  /// Stores `now` as the present contacts, with little spare capacity: buffers that were swapped
  /// from pair to pair would each grow to the longest list of all.
  void store_contacts(std::vector<Contact>& now);
  /// Lists the present contacts with their weights (Eqs. 6-8).
  void assign_weights(const std::vector<ContactPoint>& points, const RelativeMotion& motion,
                      std::vector<Contact>& now);
  void compute_effective_masses(const RelativeMotion& motion, Scratch& scratch) const;
  /// Gives contacts without a past the mean force of those that go on in their patch.
  void initialise_new_forces(Scratch& scratch) const;
  /// Loads a present contact (Eqs. 2, 4, 5) and adds what it does to both bodies.
  template <NormalLaw Law>
  void compute_contact_load(Contact& contact, const Contact* previous, const Law& law,
                            const RelativeMotion& motion, ContactLoad& load,
                            EnergyBalance& energy_balance);
  /// Ends a contact of the step before that no present one continues.
  template <NormalLaw Law>
  void end_contact(const Contact& contact, const Law& law, const RelativeMotion& motion,
                   ContactLoad& load, EnergyBalance& energy_balance) const;
  template <NormalLaw Law>
  void update_overlaps(const std::vector<Law>& laws, const EventImpulse& event,
                       const BodyMotion& block, EnergyBalance& energy_balance);
  void find_deepest_contact();
  /// Energy in all springs of the contact, with its weight, J.
  template <NormalLaw Law>
  double contact_stored_energy(const Contact& contact, const Law& law) const;

  const ContactModel& model_;
  const SurfaceFeatures& block_;
  double near_;  ///< contacts closer than this may continue each other on other features, m
  ContactPatches patches_;
  std::vector<Contact> contacts_;
  std::size_t deepest_ = 0;  ///< contact with the largest overlap, the first of such
  PairWrench last_wrench_;
  std::unique_ptr<ScarDrag> drag_;  ///< where the ground has one
  double slip_ = 0.0;               ///< how far the block has slid lately, m
  double slipped_ = 0.0;           ///< in this step, summed over the contacts with their weights, m
  double contactless_time_ = 0.0;  ///< since its last contact, s
};

}  // namespace clast::dem_detail
