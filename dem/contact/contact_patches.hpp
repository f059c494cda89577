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

  /// Computes the weight of each point. The result is valid until the next call in this thread.
  /// `patch_of` is equal for points of the same patch.
  std::span<const double> compute_weights(const std::vector<ContactPoint>& points,
                                          const Quat& orientation);
  std::size_t find_patch(std::size_t point) const { return patch_[point]; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patch_, features_, links_, all_linked_, group_points_);
  }

 private:
  /// Pair of points on the same plane or line of the block.
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
  /// Finds the patches. Two points of one feature group are in one patch if the ground between them
  /// is smooth. Patches that share a point are united.
  void find_patches(const std::vector<ContactPoint>& points, const Quat& orientation);
  /// True if the ground between two points of a feature group is smooth.
  /// @param normals_in_body  contact normals in the body frame, out of the ground
  bool is_linked(const PointLink& link, const std::vector<ContactPoint>& points,
                 std::span<const Vec3> normals_in_body) const;
  void merge_patches(std::uint32_t point, std::uint32_t other);
  /// Tests all pairs of points that are in one group but still in different patches.
  void link_remaining_points(const std::vector<ContactPoint>& points,
                             std::span<const Vec3> normals_in_body);
  /// True if the plane of a group is a side wall of the block. Side walls connect no points, so
  /// that two feet of a block are two patches.
  bool is_side_wall(std::uint32_t group, const Vec3& normal_in_body) const;
  std::uint32_t find_patch_root(std::uint32_t point);
  /// Returns the planes and straight edges of the block that contain a contact point.
  std::span<const std::uint32_t> groups_of(const ContactPoint& point,
                                           std::array<std::uint32_t, 3>& buffer) const;

  const SurfaceFeatures& block_;
  const FeatureGroups& groups_;
  ContactWeighting weights_;

  // Results of the last call. Groups depend only on the features, which rarely change.
  std::vector<std::uint32_t> patch_;  ///< per point: smallest index of a point in its patch
  std::vector<std::pair<ContactKind, std::uint32_t>> features_;  ///< block feature of each point
  /// Smallest set of links that connects the points of each group. Usually the ground is smooth
  /// along all of them, and no other pair needs a test.
  std::vector<PointLink> links_;
  bool all_linked_ = false;               ///< true if all links held in the last call
  std::vector<GroupPoint> group_points_;  ///< computed on demand
};

}  // namespace clast::dem_detail
