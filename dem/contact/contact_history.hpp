#pragma once
/// What contacts keep from step to step: which one continues which, and the springs of friction and
/// rolling resistance that it continues with.
#include <vector>

#include "dem/contact/contact_patches.hpp"

namespace clast::dem_detail {

/// A contact point with its loads before weighting.
struct Contact {
  Contact() = default;
  Contact(const ContactPoint& at, std::uint16_t ground_zone, double weight_of_point)
      : point(at), zone(ground_zone), weight(weight_of_point), position(at.position()) {}
  ContactPoint point;
  std::uint16_t zone = 0;
  double weight = 0.0;
  double normal = 0.0;             ///< N
  Vec3 tangential = Vec3::Zero();  ///< N
  Vec3 rolling = Vec3::Zero();     ///< N m
  Vec3 position = Vec3::Zero();    ///< where the force acts
  double effective_mass = 0.0;     ///< of its patch, kg; only where a law asks for it
  double stored = 0.0;             ///< with its weight, J
  double residual_indentation =
      0.0;  ///< part of the overlap that stays, m; only where a law keeps one

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(point, zone, weight, normal, tangential, rolling, position, effective_mass, stored,
          residual_indentation);
  }
};

/// It holds no state between matches, so one object can serve many pairs in turn.
class ContactHistory {
 public:
  /// Finds the contact of the step before that each point continues: each continues at most one.
  /// @param near  contacts closer than this may continue each other on other features, m
  void match_contacts(const std::vector<ContactPoint>& points, const std::vector<Contact>& before,
                      double max_distance);
  /// Of the last match: the contact that a point continues, none where it is new ...
  const Contact* previous_contact(std::size_t point, const std::vector<Contact>& before) const {
    return previous_of_[point] >= 0 ? &before[previous_of_[point]] : nullptr;
  }
  /// ... and whether a contact of the step before continues.
  bool is_continued(std::size_t contact) const { return continued_[contact]; }

  /// Gives every contact the springs that it had, and those of the weight that moved to it within
  /// its patch (docs/theory.md, Springs move with the weights).
  void transfer_springs(std::vector<Contact>& now, const std::vector<Contact>& before,
                        const ContactPatches& patches);

 private:
  /// What moves between the points of one patch when their weights change.
  struct SpringTransfer {
    double gained = 0.0, lost = 0.0;  ///< sums over the points whose weight grew, and shrank
    Vec3 tangential = Vec3::Zero();   ///< of the lost weights, N
    Vec3 rolling = Vec3::Zero();      ///< N m
  };

  /// @return  how many points it has matched
  std::size_t match_features(const std::vector<ContactPoint>& points,
                             const std::vector<Contact>& before);
  template <class Related>
  void match_by_relation(const std::vector<ContactPoint>& points,
                         const std::vector<Contact>& before, const Related& related);
  void link_contacts(std::size_t point, std::size_t contact) {
    previous_of_[point] = static_cast<int>(contact);
    continued_[contact] = 1;
  }

  std::vector<int> previous_of_;  ///< contact of the step before, -1 for none
  std::vector<char> continued_;   ///< contacts of the step before
  // Kept to spare the allocations.
  std::vector<SpringTransfer> spring_transfers_;  ///< by patch
  std::vector<double> gained_;                    ///< weight of each point, less what it had before
};

}  // namespace clast::dem_detail
