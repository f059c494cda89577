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
  /// Stores a reference to the block.
  /// @param block  block with its features; must outlive this object
  ContactPatches(const BlockSurface& block, ContactWeighting weighting)
      : block_(block.features), groups_(block.groups), weighting_(weighting) {}

  /// Computes the contact weight of each point. The result is valid until the next call in this
  /// thread.
  std::span<const double> compute_weights(const std::vector<ContactPoint>& points,
                                          const Quat& orientation);
  std::size_t patch_index(std::size_t point) const { return patch_[point]; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patch_, features_, point_pairs_, all_pairs_in_patches_, group_points_);
  }

 private:
  /// Pair of contact points on the same plane or straight edge of the block.
  struct ContactPointPair {
    std::uint32_t point = 0, earlier = 0, group = 0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(point, earlier, group);
    }
  };
  /// Contact point on a feature group (a plane or a straight edge of the block), with the index of
  /// the previous point on that group.
  struct PointInGroup {
    std::uint32_t point = 0, group = 0, before = 0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(point, group, before);
    }
  };

  bool has_same_features(const std::vector<ContactPoint>& points) const;
  void list_point_pairs(const std::vector<ContactPoint>& points);
  void list_group_points(const std::vector<ContactPoint>& points);
  /// Finds the contact patches. Two points on the same plane or straight edge of the block are in
  /// one patch if the ground between them is smooth. Patches with a common point are united.
  void find_patches(const std::vector<ContactPoint>& points, const Quat& orientation);
  /// True if the ground between the two contact points of a pair is smooth.
  /// @param normals_in_body  contact normals in the body frame, out of the ground
  bool are_in_one_patch(const ContactPointPair& pair, const std::vector<ContactPoint>& points,
                        std::span<const Vec3> normals_in_body) const;
  void merge_patches(std::uint32_t point, std::uint32_t other);
  /// Unites patches by testing all remaining pairs of points on the same plane or straight edge.
  void merge_remaining_pairs(const std::vector<ContactPoint>& points,
                             std::span<const Vec3> normals_in_body);
  /// True if a plane of the block is a side wall. Side walls do not connect points, so that two
  /// feet of a block are two patches.
  bool is_side_wall(std::uint32_t group, const Vec3& normal_in_body) const;
  std::uint32_t find_patch_root(std::uint32_t point);
  /// Returns the planes and straight edges of the block that contain a contact point.
  std::span<const std::uint32_t> feature_groups_of(const ContactPoint& point,
                                                   std::array<std::uint32_t, 3>& buffer) const;

  const SurfaceFeatures& block_;
  const FeatureGroups& groups_;
  ContactWeighting weighting_;

  // Results of the last call. Groups depend only on the features, which rarely change.
  std::vector<std::uint32_t> patch_;  ///< per point: smallest index of a point in its patch
  std::vector<std::pair<ContactKind, std::uint32_t>> features_;  ///< block feature of each point
  /// Smallest set of pairs that connects all points on each plane or straight edge. Usually the
  /// ground is smooth between all of these pairs, and no other pair needs a test.
  std::vector<ContactPointPair> point_pairs_;
  bool all_pairs_in_patches_ = false;       ///< true if each pair was in one patch in the last call
  std::vector<PointInGroup> group_points_;  ///< points on feature groups, computed on demand
};

}  // namespace clast::dem_detail
