#pragma once
/// Narrow phase of two bodies without faces: balls, capsules and rod frames. Pairs with a body that
/// has faces use `TerrainNarrowPhase` or `BlockNarrowPhase`.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

class RodNarrowPhase {
 public:
  RodNarrowPhase(const IndexedSurface& ground, const IndexedSurface& block);

  /// Finds the contacts in the ground frame in a deterministic order; the caller may modify them.
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_body);
  /// Returns the distance of the bodies, m; 0 if they touch. Valid after `find_contacts`.
  double clearance() const { return clearance_; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(clearance_);
  }

 private:
  void find_vertex_contacts(std::uint32_t block_vertex);
  void find_edge_contacts(std::uint32_t block_edge);
  /// True if `out` is in the normal cone of both vertices, so that they touch rather than their
  /// rods. kNoFeature stands for no vertex.
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
