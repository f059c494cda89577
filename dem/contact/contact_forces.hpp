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

/// Impulse that corrects the time integration for contacts that begin, reverse or end inside a
/// step. All components are in world axes.
struct CorrectionImpulse {
  Vec3 impulse = Vec3::Zero();  ///< impulse on the block, N s
  /// Angular impulse on the block about its centre of mass, N m s.
  Vec3 angular_impulse = Vec3::Zero();
  Vec3 angular_impulse_on_other = Vec3::Zero();
  // Only against what does not move; zero between two moving bodies.
  /// Correction of the position: mass times displacement of the centre, N s^2.
  Vec3 moment = Vec3::Zero();
  /// Correction of the orientation: inertia times rotation, N m s^2.
  Vec3 angular_moment = Vec3::Zero();

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(impulse, angular_impulse, angular_impulse_on_other, moment, angular_moment);
  }
};

/// Total contact force and torque on a block, in world axes. The opposite force acts on the other
/// body of the pair.
struct ContactLoad {
  Vec3 force = Vec3::Zero();   ///< force on the block, N
  Vec3 torque = Vec3::Zero();  ///< torque on the block about its centre of mass, N m
  /// Torque on the other body about its own centre of mass, N m.
  Vec3 torque_on_other = Vec3::Zero();
  /// Energy that the contacts absorb, return, or will lose when loading turns to unloading, per
  /// block mass, J/kg (docs/theory.md, Time step).
  double impact_energy = 0.0;
  /// Correction impulse to apply once, at the end of this step; null if none is needed.
  std::unique_ptr<CorrectionImpulse> correction;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(force, torque, torque_on_other, impact_energy, correction);
  }
};

/// Contacts of a block with the ground or another block over time. Each step matches the contacts
/// with those of the previous step, weights them within contact patches and computes their forces.
class ContactForces {
 public:
  /// Makes an empty set of contacts.
  /// @param model  must outlive this object, as must the block
  /// @param size  smallest side of the block, m
  ContactForces(const ContactModel& model, const BlockSurface& block, double size);

  /// Computes the contact loads after a step of `duration`, s. The dissipated energies are added to
  /// `energy_balance`.
  /// @param points  contact points at the end of the step, in world axes
  /// @param other  motion of the other body; a default `BodyMotion` for the ground
  ContactLoad update_loads(const std::vector<ContactPoint>& points, const BodyMotion& block,
                           const BodyMotion& other, double duration, EnergyBalance& energy_balance);

  /// Stores the residual indentations of the current contacts in `soil`.
  void store_indentations(SoilMemory& soil) const;

  /// Adds a time without contact in which `update_loads` was not called, s.
  void advance_time(double duration) { contactless_time_ += duration; }

  bool empty() const { return contacts_.empty(); }
  std::size_t count() const { return contacts_.size(); }
  /// Returns the effective inverse mass (mobility) of the block at its contacts, 1/kg. If weighted
  /// springs of stiffness k act at the contacts, no natural frequency of the block exceeds sqrt(k
  /// mobility).
  /// @param vertex_mobilities  inverse mass at each block vertex, 1/kg, from the function
  ///                           `vertex_mobilities`
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
  /// Computes the settled depth, m: the largest weighted mean overlap of a contact patch. Only the
  /// vertical components count, so that a block wedged between steep walls has a small depth.
  double compute_settled_depth();
  /// True if the normal law leaves residual indentations. The settled depth then depends on earlier
  /// impacts.
  bool is_plastic() const;
  /// Returns the smallest static stiffness of the current contacts, N/m. Without contacts, it is
  /// the normal stiffness k_n.
  double static_stiffness() const;

  /// Serialises the state that determines future loads.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patches_, contacts_, deepest_, last_wrench_, slip_, slipped_, contactless_time_);
    if (drag_) bytes(*drag_);
  }

 private:
  /// Force and torque of a contact patch under a unit normal force. The weights of the contact
  /// points distribute the force.
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

  template <NormalForceLaw Law>
  ContactLoad compute_loads(const std::vector<Law>& laws, const std::vector<ContactPoint>& points,
                            const RelativeMotion& motion, Scratch& scratch,
                            EnergyBalance& energy_balance);
  /// Reduces the stored slip distance of earlier contacts by the decay of the touched zone.
  void decay_slip(std::uint16_t zone);
  /// Adds the slip distance of this step, averaged over the contacts.
  void accumulate_slip();
  void add_scar_drag(const RelativeMotion& motion, ContactLoad& load,
                     EnergyBalance& energy_balance);
  /// Copies `now` to the stored contacts and limits their spare capacity.
  void store_contacts(std::vector<Contact>& now);
  /// Fills `now` with the current contacts and their weights (Eqs. 6-8).
  void assign_weights(const std::vector<ContactPoint>& points, const RelativeMotion& motion,
                      std::vector<Contact>& now);
  void compute_effective_masses(const RelativeMotion& motion, Scratch& scratch) const;
  /// Gives each new contact the mean normal force of the continued contacts of its patch.
  void initialise_new_forces(Scratch& scratch) const;
  /// Computes the load of a contact (Eqs. 2, 4, 5) and adds it to both bodies.
  template <NormalForceLaw Law>
  void compute_contact_load(Contact& contact, const Contact* previous, const Law& law,
                            const RelativeMotion& motion, ContactLoad& load,
                            EnergyBalance& energy_balance);
  /// Ends a contact of the previous step that no present contact continues.
  template <NormalForceLaw Law>
  void end_contact(const Contact& contact, const Law& law, const RelativeMotion& motion,
                   ContactLoad& load, EnergyBalance& energy_balance) const;
  template <NormalForceLaw Law>
  void update_overlaps_after_correction(const std::vector<Law>& laws,
                                        const CorrectionImpulse& event, const BodyMotion& block,
                                        EnergyBalance& energy_balance);
  void find_deepest_contact();
  /// Returns the weighted energy of all springs of a contact, J.
  template <NormalForceLaw Law>
  double contact_stored_energy(const Contact& contact, const Law& law) const;

  const ContactModel& model_;
  const SurfaceFeatures& block_;
  double max_match_distance_;  ///< largest distance of a contact from the one that it continues, m
  ContactPatches patches_;
  std::vector<Contact> contacts_;
  std::size_t deepest_ = 0;  ///< index of the contact with the largest overlap
  PairWrench last_wrench_;
  std::unique_ptr<ScarDrag> drag_;  ///< null if the ground has no scar drag
  double slip_ = 0.0;               ///< slip distance of the block, which decays without contact, m
  double slipped_ = 0.0;  ///< weighted sum of the slip distances of the contacts in this step, m
  double contactless_time_ = 0.0;  ///< time since the last contact, s
};

}  // namespace clast::dem_detail
