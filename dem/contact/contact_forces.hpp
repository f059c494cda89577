#pragma once
/// Contact forces of a pair of bodies by Eqs. 2-8 of the paper: normal force, friction and rolling
/// resistance, weighted within contact patches.
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

/// Correction impulse of contacts that begin, reverse or end inside a step, in world axes.
struct EventImpulse {
  Vec3 impulse = Vec3::Zero();          ///< on the block, N s
  Vec3 angular_impulse = Vec3::Zero();  ///< about its centre of mass, N m s
  Vec3 angular_impulse_on_other = Vec3::Zero();
  // Only against what does not move; zero between two moving bodies.
  Vec3 moment = Vec3::Zero();          ///< mass times displacement of the centre, N s^2
  Vec3 angular_moment = Vec3::Zero();  ///< inertia times rotation, N m s^2

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(impulse, angular_impulse, angular_impulse_on_other, moment, angular_moment);
  }
};

/// Force and torque of a pair's contacts, in world axes. The other body receives the opposite
/// force.
struct ContactLoad {
  Vec3 force = Vec3::Zero();   ///< on the block
  Vec3 torque = Vec3::Zero();  ///< on the block about its centre of mass
  Vec3 torque_on_other =
      Vec3::Zero();  ///< of the opposite force on the other body, about its centre of mass
  /// Energy that the contacts are absorbing, returning, or will lose at reversal, per block mass,
  /// J/kg (docs/theory.md, Time step).
  double impact = 0.0;
  /// Impulse to apply once, at the end of this step (`RigidBodyIntegrator::apply_event_impulse`).
  std::unique_ptr<EventImpulse> event;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(force, torque, torque_on_other, impact, event);
  }
};

/// Contacts of a block with the ground or another block over time: matched with the previous step,
/// weighted within their patches, and loaded by the contact law.
class ContactForces {
 public:
  /// Makes an empty set of contacts.
  /// @param model  must outlive this object, as must the block
  /// @param size  smallest side of the block, m
  ContactForces(const ContactModel& model, const BlockSurface& block, double size);

  /// Computes the loads after a step of `duration` and books all energies of the step in
  /// `energy_balance`.
  /// @param points  in world axes
  /// @param other  at rest for the ground
  ContactLoad update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                     const BodyMotion& other, double duration, EnergyBalance& energy_balance);

  /// Stores the residual indentations of the current contacts in `soil`.
  void store_indentations(SoilMemory& soil) const;

  /// Advances the time without contact and without `update`, s.
  void advance_time(double duration) { contactless_time_ += duration; }

  bool empty() const { return contacts_.empty(); }
  std::size_t count() const { return contacts_.size(); }
  /// Returns the mobility of all contacts, 1/kg: with weighted springs of stiffness k, no natural
  /// frequency of the block exceeds sqrt(k mobility).
  /// @param vertex_mobilities  of the block (`vertex_mobilities`)
  double contact_mobility(std::span<const double> vertex_mobilities) const;
  /// Returns the sum of all contact weights.
  double weight() const;
  double stored_energy() const;  ///< elastic energy, J
  double max_overlap() const { return contacts_.empty() ? 0.0 : contacts_[deepest_].point.overlap; }
  struct DeepestContact {
    std::uint32_t contact_count = 0;  ///< total number of contact points
    double overlap = 0.0;             ///< m
    Vec3 position = Vec3::Zero();
    std::uint16_t zone = 0;
  };
  /// Returns the contact with the largest overlap; empty without contacts.
  std::optional<DeepestContact> deepest_contact() const;
  /// Returns the largest vertical depth of the load-bearing patches, m. A wedge between steep walls
  /// is tight but not deep.
  double compute_settled_depth();
  /// True if the law leaves residual indentations, so that impacts rather than the weight determine
  /// the settled depth.
  bool is_plastic() const;
  /// Returns the smallest static stiffness of the current contacts, or k_n without contacts, N/m.
  double static_stiffness() const;

  /// Serialises the state that determines future loads.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patches_, contacts_, deepest_, last_wrench_, slip_, slipped_, contactless_time_);
    if (drag_) bytes(*drag_);
  }

 private:
  /// Force and torque of a patch's unit force through all its points.
  struct PatchWrench {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    Vec3 torque_on_other = Vec3::Zero();
  };

  /// Total contact force and torque at the end of the last step, in world axes: `force` on the
  /// block and its opposite on the other body.
  struct PairWrench {
    PairWrench() = default;
    PairWrench(const ContactLoad& load, const RelativeMotion& motion);
    /// Returns the power taken from the mean motion over the previous step, W.
    double power_over_previous_step(const RelativeMotion& motion) const;
    /// Returns the power taken from the mean motion over the next step, W.
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

  /// Temporary data of one update, shared by all pairs of a thread.
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
  /// Decays the slip of earlier contacts by the memory of the touched ground.
  void decay_slip(std::uint16_t zone);
  /// Accumulates the slip of this step, averaged over the contacts.
  void accumulate_slip();
  void add_drag(const RelativeMotion& motion, ContactLoad& load, EnergyBalance& energy_balance);
  /// Stores `now` as the current contacts with little spare capacity; swapping buffers between
  /// pairs would grow each to the longest list.
  void store_contacts(std::vector<Contact>& now);
  /// Lists the current contacts with their weights (Eqs. 6-8).
  void assign_weights(const std::vector<ContactPoint>& points, const RelativeMotion& motion,
                      std::vector<Contact>& now);
  void compute_effective_masses(const RelativeMotion& motion, Scratch& scratch) const;
  /// Sets new contacts to the mean force of the continued contacts of their patch.
  void initialise_new_forces(Scratch& scratch) const;
  /// Computes the load of a contact (Eqs. 2, 4, 5) and adds it to both bodies.
  template <NormalLaw Law>
  void compute_contact_load(Contact& contact, const Contact* previous, const Law& law,
                            const RelativeMotion& motion, ContactLoad& load,
                            EnergyBalance& energy_balance);
  /// Ends a contact of the previous step that is not continued.
  template <NormalLaw Law>
  void end_contact(const Contact& contact, const Law& law, const RelativeMotion& motion,
                   ContactLoad& load, EnergyBalance& energy_balance) const;
  template <NormalLaw Law>
  void update_overlaps(const std::vector<Law>& laws, const EventImpulse& event,
                       const BodyMotion& block, EnergyBalance& energy_balance);
  void find_deepest_contact();
  /// Returns the weighted energy of all springs of a contact, J.
  template <NormalLaw Law>
  double contact_stored_energy(const Contact& contact, const Law& law) const;

  const ContactModel& model_;
  const SurfaceFeatures& block_;
  double near_;  ///< maximum distance of contacts that may continue each other on different
                 ///< features, m
  ContactPatches patches_;
  std::vector<Contact> contacts_;
  std::size_t deepest_ = 0;  ///< contact with the largest overlap, the first of such
  PairWrench last_wrench_;
  std::unique_ptr<ScarDrag> drag_;  ///< null if the ground has no scar drag
  double slip_ = 0.0;               ///< how far the block has slid lately, m
  double slipped_ = 0.0;           ///< in this step, summed over the contacts with their weights, m
  double contactless_time_ = 0.0;  ///< time since the last contact, s
};

}  // namespace clast::dem_detail
