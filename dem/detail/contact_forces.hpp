#pragma once
/// Forces of the contact points of one pair of bodies, with the history that Eqs. 2-5 of the paper
/// ask for. @cite garcia2022
#include <optional>
#include <span>
#include <vector>

#include "dem/detail/contact_patches.hpp"
#include "dem/energy_ledger.hpp"

namespace clast::dem_detail {

/// How a body moved over a step: its place at the end, its mean velocities, and those it began
/// with. A body that does not move is the default.
struct BodyMotion {
  Pose world_from_body;                  ///< origin at the centre of mass
  Vec3 velocity = Vec3::Zero();          ///< of the centre, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s, world axes

  Vec3 begin_position = Vec3::Zero();  ///< of the centre
  Vec3 begin_velocity = Vec3::Zero();
  Vec3 begin_angular_velocity = Vec3::Zero();

  double inverse_mass = 0.0;            ///< 1/kg; 0 for a body that is fixed
  Vec3 inverse_moments = Vec3::Zero();  ///< along the body axes, 1/(kg m^2)

  Vec3 velocity_at(const Vec3& point) const {
    return velocity + angular_velocity.cross(point - world_from_body.translation);
  }
  /// The mean velocity of what was at `point` when the step began.
  Vec3 velocity_from(const Vec3& point) const {
    return velocity + angular_velocity.cross(point - begin_position);
  }
  Vec3 begin_velocity_at(const Vec3& point) const {
    return begin_velocity + begin_angular_velocity.cross(point - begin_position);
  }
  /// False for what stood still all the step, as the ground does.
  bool moves() const {
    return !(velocity.isZero(0.0) && angular_velocity.isZero(0.0) && begin_velocity.isZero(0.0) &&
             begin_angular_velocity.isZero(0.0));
  }
  /// Inverse inertia times a torque, both in world axes.
  Vec3 turned_by(const Vec3& torque) const {
    const Vec3 in_body = world_from_body.rotation.conjugate() * torque;
    return world_from_body.rotation * Vec3(inverse_moments.cwiseProduct(in_body));
  }
};

/// What laws that start, reverse or end inside a step add to it, in world axes.
struct EventLoad {
  Vec3 impulse = Vec3::Zero();          ///< on the block, N s
  Vec3 angular_impulse = Vec3::Zero();  ///< about its centre of mass, N m s
  Vec3 angular_impulse_on_other = Vec3::Zero();
  // Only against what does not move; zero between two moving bodies.
  Vec3 moment = Vec3::Zero();          ///< mass times shift of the centre, N s^2
  Vec3 angular_moment = Vec3::Zero();  ///< inertia times turn, N m s^2
};

/// What the contacts of a pair do to its bodies, in world axes. The other body gets -force.
struct ContactLoad {
  Vec3 force = Vec3::Zero();            ///< on the block
  Vec3 torque = Vec3::Zero();           ///< on the block about its centre of mass
  Vec3 torque_on_other = Vec3::Zero();  ///< on the other body about its own
  /// To be given once, at the end of this step (`MovingBody::correct`).
  std::optional<EventLoad> event;
};

/// The contacts of a block with the ground, or with another block, over time: matched from step to
/// step, loaded by the law, weighted.
class ContactForces {
 public:
  /// @param zones         parameters of each ground zone
  /// @param zone_of_face  of the other surface; empty: all are of zone 0
  /// @param block         must outlive the forces
  /// @param size          smallest side of the block, m
  ContactForces(std::span<const GroundParameters> zones,
                std::span<const std::uint16_t> zone_of_face, const BlockSurface& block, double size,
                const ContactStiffness& stiffness, ContactWeights weights,
                const ContactLaw& law = {});

  /// Loads at the present contacts after a step of `duration`. Books every joule of the step in
  /// `ledger`.
  /// @param points  in world axes
  /// @param other   the ground does not move
  ContactLoad update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                     const BodyMotion& other, double duration, EnergyLedger& ledger);

  bool empty() const { return contacts_.empty(); }
  double stored_energy() const;  ///< what unloading would give back, J
  double max_overlap() const;    ///< m
  struct Deepest {
    std::uint32_t points = 0;  ///< all there are
    double overlap = 0.0;      ///< m
    Vec3 place = Vec3::Zero();
    std::uint16_t zone = 0;
  };
  /// The contact with the largest overlap; none without contacts.
  std::optional<Deepest> deepest() const;
  /// Deepest of the laws that carry the block, vertically, m: a wedge between steep walls is tight
  /// but not deep.
  double settled_depth();
  /// Smallest stiffness with which a present contact carries a body at rest; k_n without any, N/m.
  double rest_stiffness() const;

 private:
  /// A contact point with its loads before weighting.
  struct Contact {
    Contact(const ContactPoint& at, std::uint16_t ground_zone, double share)
        : point(at), zone(ground_zone), weight(share), place(at.point()) {}
    ContactPoint point;
    std::uint16_t zone;
    double weight;
    double normal = 0.0;             ///< N
    Vec3 tangential = Vec3::Zero();  ///< N
    Vec3 rolling = Vec3::Zero();     ///< N m
    Vec3 place;                      ///< where the force acts
    double effective_mass = 0.0;     ///< of its law, kg; only where a law asks for it
    double stored = 0.0;             ///< with its weight, J
  };
  /// What the unit force of one law does through all its points.
  struct LawAction {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    Vec3 torque_on_other = Vec3::Zero();
  };

  /// What moves between the points of one law when their weights change.
  struct HandedShare {
    double gained = 0.0, lost = 0.0;  ///< sums over the points whose weight grew, and shrank
    Vec3 tangential = Vec3::Zero();   ///< of the lost shares, N
    Vec3 rolling = Vec3::Zero();      ///< N m
  };

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

  template <class Law>
  ContactLoad updated(const std::vector<Law>& laws, const std::vector<ContactPoint>& points,
                      const BodyMotion& block, const BodyMotion& other, double duration,
                      EnergyLedger& ledger);
  void match(const std::vector<ContactPoint>& points);
  /// Gives every point the springs it had, and those of the shares that moved to it.
  void hand_on_springs();
  void find_effective_masses(const BodyMotion& block, const BodyMotion& other);
  template <class Law>
  void shift_overlaps(const std::vector<Law>& laws, const EventLoad& event, const BodyMotion& block,
                      EnergyLedger& ledger);
  /// Energy in all springs of the contact, with its weight, J.
  template <class Law>
  double stored_in(const Contact& contact, const Law& law) const;

  std::span<const GroundParameters> zones_;
  std::span<const std::uint16_t> zone_of_face_;
  LawsOf<ContactLaw>::Type laws_;
  ContactPatches patches_;
  ContactStiffness stiffness_;
  double tangential_give_, rolling_give_;  ///< 1/k_t, 1/k_r
  double near_;  ///< contacts closer than this may hand their history on, m
  std::vector<Contact> contacts_;

  // Scratch of one update, kept to spare the allocations.
  std::vector<Contact> now_;
  std::vector<int> previous_of_;  ///< contact of the step before, -1 for none
  std::vector<char> carried_on_;  ///< contacts of the step before that live on
  std::vector<LawAction> law_action_;
  std::vector<HandedShare> handed_;
};

}  // namespace clast::dem_detail
