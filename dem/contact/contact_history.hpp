#pragma once
/// Contact history: matches contacts of consecutive steps and transfers their spring loads.
#include <vector>

#include "dem/contact/contact_patches.hpp"

namespace clast::dem_detail {

/// Contact point with its loads. The forces are per unit of contact weight.
struct Contact {
  Contact() = default;
  Contact(const ContactPoint& at, std::uint16_t ground_zone, double weight_of_point)
      : point(at), zone(ground_zone), weight(weight_of_point), position(at.position()) {}
  ContactPoint point;
  std::uint16_t zone = 0;
  double weight = 0.0;
  double normal_force = 0.0;             ///< normal force, N
  Vec3 tangential_force = Vec3::Zero();  ///< load of the tangential spring, N
  Vec3 rolling_moment = Vec3::Zero();    ///< moment of the rolling spring, N m
  Vec3 position = Vec3::Zero();          ///< point of application
  /// Effective mass of the contact patch, kg; only for laws that need it.
  double effective_mass = 0.0;
  double stored_energy = 0.0;         ///< weighted elastic energy, J
  double residual_indentation = 0.0;  ///< depth that remains without load, m; only for plastic laws

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(point, zone, weight, normal_force, tangential_force, rolling_moment, position,
          effective_mass, stored_energy, residual_indentation);
  }
};

/// Matches the contacts of two consecutive steps. One object can serve many pairs of bodies in
/// turn.
class ContactHistory {
 public:
  /// Matches each point with at most one contact of the previous step.
  /// @param max_distance  largest distance between a point and the contact that it continues on
  ///                      other features, m
  void match_contacts(const std::vector<ContactPoint>& points, const std::vector<Contact>& before,
                      double max_distance);
  /// Returns the contact of the previous step that a point continues; null if the point is new.
  const Contact* previous_contact(std::size_t point, const std::vector<Contact>& before) const {
    return previous_of_[point] >= 0 ? &before[previous_of_[point]] : nullptr;
  }
  /// True if a present contact continues the given contact of the previous step.
  bool is_continued(std::size_t contact) const { return continued_[contact]; }

  /// Transfers the spring loads of the previous contacts to the contacts that continue them. If
  /// contact weight moves between the points of a patch, spring load moves with it
  /// (docs/theory.md).
  void transfer_springs(std::vector<Contact>& now, const std::vector<Contact>& before,
                        const ContactPatches& patches);

 private:
  /// Spring loads that move between the points of a contact patch because their weights change.
  struct SpringTransfer {
    double gained = 0.0, lost = 0.0;  ///< sums of the weight increases and decreases
    /// Load of the tangential springs that belongs to the lost weights, N.
    Vec3 tangential_force = Vec3::Zero();
    /// Load of the rolling springs that belongs to the lost weights, N m.
    Vec3 rolling_moment = Vec3::Zero();
  };

  /// Matches points with contacts of the previous step on the same block and ground features.
  /// @return number of matched points
  std::size_t match_features(const std::vector<ContactPoint>& points,
                             const std::vector<Contact>& before);
  template <class Related>
  void match_by_relation(const std::vector<ContactPoint>& points,
                         const std::vector<Contact>& before, const Related& related);
  void continue_contact(std::size_t point, std::size_t contact) {
    previous_of_[point] = static_cast<int>(contact);
    continued_[contact] = 1;
  }

  std::vector<int> previous_of_;  ///< per point: index of the contact that it continues, -1 if none
  std::vector<char> continued_;   ///< per contact of the previous step: 1 if a point continues it
  // Kept to spare the allocations.
  std::vector<SpringTransfer> spring_transfers_;  ///< per patch
  std::vector<double> gained_;  ///< weight change of each point since the previous step
};

}  // namespace clast::dem_detail
