#pragma once
/// Contact forces of a pair of bodies by Eqs. 2-8 of the cited paper: normal force, friction and
/// rolling resistance. The forces of the contact points are weighted within contact patches.
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

/// Correction impulse for contacts that begin, reverse or end inside a step, in world axes.
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

/// Sum of forces and torques of a pair's contacts, world axes. Its reaction acts on the other body.
struct ContactLoad {
  Vec3 force = Vec3::Zero();            ///< on the block
  Vec3 torque = Vec3::Zero();           ///< on the block about its centre of mass
  Vec3 torque_on_other = Vec3::Zero();  ///< on the other body, about its own centre of mass
  /// Energy of an impact, per block mass, J/kg: what the contacts absorb or return, or will lose at
  /// reversal (docs/theory.md, Time step).
  double impact = 0.0;
  /// Impulse to apply once, at the end of this step (`RigidBodyIntegrator::apply_event_impulse`).
  std::unique_ptr<EventImpulse> event;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(force, torque, torque_on_other, impact, event);
  }
};

/// Contacts of a block with the ground or another block over time. Each step matches them with
/// those of the previous step, weights them within their patches and computes their forces.
class ContactForces {
 public:
  /// Makes an empty set of contacts.
  /// @param model  must outlive this object, as must the block
  /// @param size  smallest side of the block, m
  ContactForces(const ContactModel& model, const BlockSurface& block, double size);

  /// Computes the loads after a step of `duration` and adds its energies to `energy_balance`.
  /// @param points  contact points at the end of the step, in world axes
  /// @param other  motion of the other body; default `BodyMotion` for the ground
  ContactLoad update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                     const BodyMotion& other, double duration, EnergyBalance& energy_balance);

  /// Stores the residual indentations of the current contacts in `soil`.
  void store_indentations(SoilMemory& soil) const;

  /// Adds a time without contact in which `update` was not called, s.
  void advance_time(double duration) { contactless_time_ += duration; }

  bool empty() const { return contacts_.empty(); }
  std::size_t count() const { return contacts_.size(); }
  /// Returns an effective inverse mass of the block at its contacts, 1/kg. With weighted springs of
  /// stiffness k at the contacts, no natural frequency of the block exceeds sqrt(k mobility).
  /// @param vertex_mobilities  of the block, from `vertex_mobilities`
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
  /// Returns the largest weighted mean overlap of a patch, m. Only vertical components count, so
  /// that a block wedged between steep walls is not deep.
  double compute_settled_depth();
  /// True if the law leaves residual indentations. The settled depth then depends on impacts.
  bool is_plastic() const;
  /// Returns the smallest static stiffness of the current contacts, N/m; k_n without contacts.
  double static_stiffness() const;

  /// Serialises the state that determines future loads.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patches_, contacts_, deepest_, last_wrench_, slip_, slipped_, contactless_time_);
    if (drag_) bytes(*drag_);
  }

 private:
  /// Force and torque of a patch for a unit normal force, distributed by the weights of its points.
  struct PatchWrench {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    Vec3 torque_on_other = Vec3::Zero();
  };

  /// Total contact force and torque at the end of the last step, in world axes. `force` acts on the
  /// block, its opposite on the other body.
  struct PairWrench {
    PairWrench() = default;
    PairWrench(const ContactLoad& load, const RelativeMotion& motion);
    /// Returns the power that the wrench takes from the mean motion over the previous step, W.
    double power_over_previous_step(const RelativeMotion& motion) const;
    /// Returns the power that the wrench takes from the mean motion over the next step, W.
    double power_over_next_step(const RelativeMotion& motion) const;

    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();           ///< on the block about its centre of mass
    Vec3 torque_on_other = Vec3::Zero();  ///< on the other body about its centre, negated
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
  /// Reduces the slip of earlier contacts by the slip memory of the touched zone.
  void decay_slip(std::uint16_t zone);
  /// Accumulates the slip of this step, averaged over the contacts.
  void accumulate_slip();
  void add_drag(const RelativeMotion& motion, ContactLoad& load, EnergyBalance& energy_balance);
  /// Copies `now` to the current contacts, with little spare capacity.
  void store_contacts(std::vector<Contact>& now);
  /// Fills `now` with the current contacts and their weights (Eqs. 6-8).
  void assign_weights(const std::vector<ContactPoint>& points, const RelativeMotion& motion,
                      std::vector<Contact>& now);
  void compute_effective_masses(const RelativeMotion& motion, Scratch& scratch) const;
  /// Gives each new contact the mean normal force of the continued contacts of its patch.
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
  double near_;  ///< largest distance over which a contact may continue on other features, m
  ContactPatches patches_;
  std::vector<Contact> contacts_;
  std::size_t deepest_ = 0;  ///< index of the contact with the largest overlap
  PairWrench last_wrench_;
  std::unique_ptr<ScarDrag> drag_;  ///< null if the ground has no scar drag
  double slip_ = 0.0;               ///< slip distance of the block, reduced by the slip memory, m
  double slipped_ = 0.0;            ///< weighted sum of the contacts' slip in this step, m
  double contactless_time_ = 0.0;   ///< time since the last contact, s
};

}  // namespace clast::dem_detail
