#pragma once
/// Contact patches, and the weights of the contact points in them.
/// @cite garcia2022 (Eqs. 6-8)
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

/// Weights of the contact points of one pair of bodies.
class ContactPatches {
 public:
  /// Stores the block.
  /// @param block  must outlive the patches
  ContactPatches(const BlockSurface& block, ContactWeighting weights)
      : block_(block.features), groups_(block.groups), weights_(weights) {}

  /// Computes the weight of each point, valid until the next call in this thread. Points of one
  /// patch have equal `patch_of`.
  std::span<const double> compute_weights(const std::vector<ContactPoint>& points,
                                          const Quat& orientation);
  std::size_t find_patch(std::size_t point) const { return patch_[point]; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patch_, features_, links_, all_linked_, group_points_);
  }

 private:
  /// Two points on the same plane or line of the block.
  struct PointLink {
    std::uint32_t point = 0, earlier = 0, group = 0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(point, earlier, group);
    }
  };
  /// Point on a feature group, linked to the previous point of that group.
  struct GroupPoint {
    std::uint32_t point = 0, group = 0, before = 0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(point, group, before);
    }
  };

  bool has_same_features(const std::vector<ContactPoint>& points) const;
  void list_candidate_links(const std::vector<ContactPoint>& points);
  void list_group_points(const std::vector<ContactPoint>& points);
  /// Finds the patches: points of one feature group with smooth ground between them, and their
  /// unions.
  void find_patches(const std::vector<ContactPoint>& points, const Quat& orientation);
  /// True if the ground between two points of a feature group is smooth.
  /// @param normals_in_body  of the points, out of the ground
  bool is_linked(const PointLink& link, const std::vector<ContactPoint>& points,
                 std::span<const Vec3> normals_in_body) const;
  void merge_patches(std::uint32_t point, std::uint32_t other);
  /// Tests all pairs of points of a group that are still in different patches.
  void link_remaining_points(const std::vector<ContactPoint>& points,
                             std::span<const Vec3> normals_in_body);
  /// True for a side wall, which does not connect points on the ground, so that two feet stay two
  /// patches.
  bool is_side_wall(std::uint32_t group, const Vec3& normal_in_body) const;
  std::uint32_t find_patch_root(std::uint32_t point);
  /// Returns the planes and straight edges of the block that contain a contact point.
  std::span<const std::uint32_t> groups_of(const ContactPoint& point,
                                           std::array<std::uint32_t, 3>& buffer) const;

  const SurfaceFeatures& block_;
  const FeatureGroups& groups_;
  ContactWeighting weights_;

  // Of the last call. The joints depend only on the features, which mostly stay from call to call.
  std::vector<std::uint32_t> patch_;  ///< smallest point of the same patch
  std::vector<std::pair<ContactKind, std::uint32_t>> features_;  ///< of the block, by point
  /// Minimal links that connect all groups; usually all of them hold and no other pair needs a
  /// test.
  std::vector<PointLink> links_;
  bool all_linked_ = false;  ///< in the last call; then the same links leave the same patches
  std::vector<GroupPoint> group_points_;  ///< computed on demand
};

}  // namespace clast::dem_detail
