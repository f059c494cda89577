#pragma once
/// Contacts of two bodies that have no faces: balls, capsules, frames of rods. A body with faces is
/// the reference of its pair (`TerrainNarrowPhase`); between two without there is nothing to index.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

class RodNarrowPhase {
 public:
  RodNarrowPhase(const IndexedSurface& ground, const IndexedSurface& block);

  /// The contacts in the frame of the ground, in a fixed order; the caller may change them.
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_body);
  /// How far apart the two are at least, m; 0 in contact (valid after `contacts`).
  double clearance() const { return clearance_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(clearance_);
  }

 private:
  void find_vertex_contacts(std::uint32_t block_vertex);
  void find_edge_contacts(std::uint32_t block_edge);
  /// A vertex acts where no rod that leaves it comes nearer; kNoFeature: no vertex there.
  bool is_vertex_contact(std::uint32_t block_vertex, std::uint32_t ground_vertex,
                         const Vec3& out) const;
  void set_contact(ContactPoint& contact, const Vec3& on_ground, const Vec3& on_block);

  const IndexedSurface& ground_;
  const SurfaceFeatures& block_;
  double reach_;  ///< both radii, m
  double clearance_ = 0.0;
  Mat3 rotation_ = Mat3::Identity();
  std::vector<Vec3> placed_;  ///< block vertices in the frame of the ground
  std::vector<ContactPoint> contacts_;
};

}  // namespace clast::dem_detail
