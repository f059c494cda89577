#pragma once
/// Narrow phase: contact points of two bodies without faces, such as balls, capsules and frames of
/// rods.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

class RodNarrowPhase {
 public:
  RodNarrowPhase(const IndexedSurface& ground, const IndexedSurface& block);

  /// Finds the contacts, in the ground frame and in a deterministic order. The caller may modify
  /// the list.
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_body);
  /// Returns the distance between the bodies, m; 0 if they touch. Valid after `find_contacts`.
  double clearance() const { return clearance_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(clearance_);
  }

 private:
  void find_vertex_contacts(std::uint32_t block_vertex);
  void find_edge_contacts(std::uint32_t block_edge);
  /// True if two vertices touch, rather than their rods: `out` lies in the normal cones of both.
  /// kNoFeature stands for no vertex.
  bool is_vertex_contact(std::uint32_t block_vertex, std::uint32_t ground_vertex,
                         const Vec3& out) const;
  void set_contact(ContactPoint& contact, const Vec3& on_ground, const Vec3& on_block);

  const IndexedSurface& ground_;
  const SurfaceFeatures& block_;
  double reach_;  ///< sum of both radii, m
  double clearance_ = 0.0;
  Mat3 rotation_ = Mat3::Identity();
  std::vector<Vec3> block_vertices_in_ground_;  ///< block vertices in the frame of the ground
  std::vector<ContactPoint> contacts_;
};

}  // namespace clast::dem_detail
