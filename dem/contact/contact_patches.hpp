#pragma once
/// Contact patches: points that act as one, and the share of the stiffness that each carries.
/// @cite garcia2022 (Eqs. 6-8)
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

/// The weights of the contact points of one pair of bodies.
class ContactPatches {
 public:
  /// @param block  must outlive the patches
  ContactPatches(const BlockSurface& block, ContactWeighting weights)
      : block_(block.features), groups_(block.groups), weights_(weights) {}

  /// Weight of every point, valid until the next call in this thread. Points of one patch have the
  /// same number in `patch_of`.
  std::span<const double> compute_weights(const std::vector<ContactPoint>& points,
                                          const Quat& orientation);
  std::size_t patch_of(std::size_t point) const { return patch_[point]; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(patch_, features_, links_, all_linked_, group_points_);
  }

 private:
  /// Two points that lie on the same plane or line of the block.
  struct PointLink {
    std::uint32_t point = 0, earlier = 0, group = 0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(point, earlier, group);
    }
  };
  /// A point on a joint, chained to the one before on the same joint.
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
  /// Finds the patches: points of one joint with smooth ground between them, and what those join.
  void find_patches(const std::vector<ContactPoint>& points, const Quat& orientation);
  /// Whether the ground joins two points that the block may.
  /// @param normals_in_body  of the points, out of the ground
  bool is_linked(const PointLink& link, const std::vector<ContactPoint>& points,
                 std::span<const Vec3> normals_in_body) const;
  void merge_patches(std::uint32_t point, std::uint32_t other);
  /// Tries every two points of a joint that are of different patches so far.
  void link_remaining_points(const std::vector<ContactPoint>& points,
                             std::span<const Vec3> normals_in_body);
  /// A side wall joins no points on the ground: two feet stay two.
  bool is_side_wall(std::uint32_t group, const Vec3& normal_in_body) const;
  std::uint32_t find_patch_root(std::uint32_t point);
  /// Planes and straight edges of the block that a contact point lies on.
  std::span<const std::uint32_t> groups_of(const ContactPoint& point,
                                           std::array<std::uint32_t, 3>& buffer) const;

  const SurfaceFeatures& block_;
  const FeatureGroups& groups_;
  ContactWeighting weights_;

  // Of the last call. The joints depend only on the features, which mostly stay from call to call.
  std::vector<std::uint32_t> patch_;  ///< smallest point of the same patch
  std::vector<std::pair<ContactKind, std::uint32_t>> features_;  ///< of the block, by point
  /// As few as join all that the joints can: mostly every one of them does, and no other pair of
  /// points needs a look.
  std::vector<PointLink> links_;
  bool all_linked_ = false;  ///< in the last call; then the same links leave the same patches
  std::vector<GroupPoint> group_points_;  ///< of these features; empty while nobody has asked
};

}  // namespace clast::dem_detail
