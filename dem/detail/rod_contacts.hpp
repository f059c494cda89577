#pragma once
/// Contacts of two bodies that have no faces: balls, capsules, frames of rods. A body with faces is
/// the reference of its pair (`ContactSearch`); between two without there is nothing to index.
#include <vector>

#include "dem/detail/contact_search.hpp"

namespace clast::dem_detail {

class RodContacts {
 public:
  RodContacts(const IndexedSurface& ground, const IndexedSurface& block);

  /// The contacts in the frame of the ground, in a fixed order.
  const std::vector<ContactPoint>& contacts(const Pose& ground_from_body);
  /// How far apart the two are at least, m; 0 in contact (valid after `contacts`).
  double clearance() const { return clearance_; }

 private:
  void touch(ContactPoint& contact, const Vec3& on_ground, const Vec3& on_block);

  const IndexedSurface& ground_;
  const SurfaceFeatures& block_;
  double reach_;  ///< both radii, m
  double clearance_ = 0.0;
  std::vector<Vec3> placed_;  ///< block vertices in the frame of the ground
  std::vector<ContactPoint> contacts_;
};

}  // namespace clast::dem_detail
