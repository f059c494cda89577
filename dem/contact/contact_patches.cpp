#include "dem/contact/contact_patches.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "dem/surface/trim.hpp"

namespace clast::dem_detail {
namespace {

/// Normals within a patch differ by at most 30 degrees. Larger angles are ridges.
constexpr double kPatchCosine = 0.8660254037844386;
/// Largest height of a point of a patch above the tangent plane of another, as a sine (3 degrees).
/// If it is larger, the ground is a valley whose two sides carry the block separately.
constexpr double kPatchRise = 0.052;
/// A plane of the block connects contact points if it faces the ground within 60 degrees.
constexpr double kFacingCosine = 0.5;

/// True if the ground between two contacts is flat or smoothly convex.
bool smooth_between(const ContactPoint& a, const ContactPoint& b) {
  if (a.normal.dot(b.normal) < kPatchCosine) return false;
  const Vec3 between = b.surface_point - a.surface_point;
  const double rise = kPatchRise * between.norm();
  return a.normal.dot(between) <= rise && b.normal.dot(between) >= -rise;
}

/// True if two vertices touch the same face of the ground inside it.
bool on_one_face(const ContactPoint& a, const ContactPoint& b) {
  return a.ground_face == b.ground_face && a.kind == ContactKind::kVertexGround &&
         b.kind == ContactKind::kVertexGround && a.normal == b.normal;
}

/// Last index stored for each feature group of a block. Clearing by `begin` costs nothing.
class LastOnJoint {
 public:
  void begin(const SurfaceFeatures& block) {
    ++round_;
    const std::size_t groups = block.faces.size() + block.edges.size();
    if (noted_.size() < groups) noted_.resize(groups);
  }
  /// @return  index stored before; kNoFeature if none
  std::uint32_t note(std::uint32_t group, std::uint32_t index) {
    const Noted before = std::exchange(noted_[group], {round_, index});
    return before.round == round_ ? before.index : kNoFeature;
  }

 private:
  struct Noted {
    std::uint64_t round = 0;
    std::uint32_t index = 0;
  };
  std::vector<Noted> noted_;
  std::uint64_t round_ = 0;
};

/// Temporary data of one call, shared by all pairs of a thread.
struct Scratch {
  std::vector<double> point_weights, patch_overlap;
  std::vector<Vec3> normals_in_body;
  LastOnJoint last_on_joint;
};
Scratch& scratch() {
  thread_local Scratch scratch;
  return scratch;
}

}  // namespace

std::span<const double> ContactPatches::compute_weights(const std::vector<ContactPoint>& points,
                                                        const Quat& orientation) {
  const std::size_t count = points.size();
  std::vector<double>&point_weights = scratch().point_weights,
  &patch_overlap = scratch().patch_overlap;
  if (count < 2) {  // under all rules
    patch_.assign(count, 0);
    point_weights.assign(count, 1.0);
    features_.clear();
    return point_weights;
  }
  point_weights.assign(
      count, weighting_ == ContactWeighting::kCount ? 1.0 / static_cast<double>(count) : 1.0);
  if (weighting_ == ContactWeighting::kPatch) {
    find_patches(points, orientation);
  } else {
    patch_.assign(count, 0);
    if (weighting_ == ContactWeighting::kNone) std::iota(patch_.begin(), patch_.end(), 0u);
    if (weighting_ != ContactWeighting::kOverlap) return point_weights;
  }
  patch_overlap.assign(count, 0.0);
  double* sum = patch_overlap.data();
  double sum_so_far = 0.0;  // of the present patch: most neighbours in the list share theirs
  for (std::size_t i = 0; i < count; ++i) {
    if (double* const of_point = &patch_overlap[patch_[i]]; of_point != sum) {
      *sum = sum_so_far;
      sum = of_point;
      sum_so_far = *sum;
    }
    sum_so_far += points[i].overlap;
  }
  *sum = sum_so_far;
  for (std::size_t i = 0; i < count; ++i)
    point_weights[i] = points[i].overlap / patch_overlap[patch_[i]];
  return point_weights;
}

std::span<const std::uint32_t> ContactPatches::feature_groups_of(
    const ContactPoint& point, std::array<std::uint32_t, 3>& buffer) const {
  if (point.kind == ContactKind::kVertexGround) return groups_.groups_at(point.block_feature);
  if (point.kind == ContactKind::kFaceVertex) {
    buffer[0] = groups_.group_of_face[point.block_feature];
    return {buffer.data(), 1};
  }
  const SurfaceEdge& edge = block_.edges[point.block_feature];
  std::size_t count = 0;
  buffer[count++] = groups_.group_of_edge[point.block_feature];
  for (const std::uint32_t face : edge.faces) {
    if (face != kNoFeature) buffer[count++] = groups_.group_of_face[face];
  }
  return {buffer.data(), count};
}

bool ContactPatches::has_same_features(const std::vector<ContactPoint>& points) const {
  if (points.size() != features_.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (features_[i] != std::pair(points[i].kind, points[i].block_feature)) return false;
  }
  return true;
}

void ContactPatches::list_point_pairs(const std::vector<ContactPoint>& points) {
  features_.clear();
  point_pairs_.clear();
  if (group_points_.empty()) group_points_.shrink_to_fit();  // not used since the last change
  group_points_.clear();
  patch_.resize(points.size());
  LastOnJoint& last = scratch().last_on_joint;
  last.begin(block_);
  std::iota(patch_.begin(), patch_.end(), 0u);
  std::array<std::uint32_t, 3> buffer;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    features_.emplace_back(points[i].kind, points[i].block_feature);
    std::uint32_t patch = i;
    for (const std::uint32_t group : feature_groups_of(points[i], buffer)) {
      const std::uint32_t earlier = last.note(group, i);
      if (earlier == kNoFeature) continue;
      const std::uint32_t other = find_patch_root(earlier);
      if (other == patch) continue;
      point_pairs_.push_back({i, earlier, group});
      patch = patch_[std::max(patch, other)] = std::min(patch, other);
    }
  }
}

void ContactPatches::find_patches(const std::vector<ContactPoint>& points,
                                  const Quat& orientation) {
  const bool same_links = has_same_features(points);
  if (!same_links) list_point_pairs(points);
  std::vector<Vec3>& normals_in_body = scratch().normals_in_body;
  const Mat3 body_from_world = orientation.toRotationMatrix().transpose();
  normals_in_body.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool same = i > 0 && points[i].normal == points[i - 1].normal;
    normals_in_body[i] = same ? normals_in_body[i - 1] : Vec3(body_from_world * points[i].normal);
  }
  const auto may_join = [&](const ContactPointPair& pair) {
    return are_in_one_patch(pair, points, normals_in_body);
  };
  if (same_links && all_pairs_in_patches_ &&
      std::all_of(point_pairs_.begin(), point_pairs_.end(), may_join))
    return;
  std::iota(patch_.begin(), patch_.end(), 0u);
  all_pairs_in_patches_ = true;
  for (const ContactPointPair& pair : point_pairs_) {
    if (may_join(pair)) {
      merge_patches(pair.point, pair.earlier);
    } else {
      all_pairs_in_patches_ = false;
    }
  }
  if (!all_pairs_in_patches_) merge_remaining_pairs(points, normals_in_body);
  for (std::uint32_t& patch : patch_) patch = patch_[patch];
}

void ContactPatches::list_group_points(const std::vector<ContactPoint>& points) {
  LastOnJoint& last = scratch().last_on_joint;
  last.begin(block_);
  std::array<std::uint32_t, 3> buffer;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (const std::uint32_t group : feature_groups_of(points[i], buffer)) {
      const auto entry = static_cast<std::uint32_t>(group_points_.size());
      group_points_.push_back({i, group, last.note(group, entry)});
    }
  }
  shrink_capacity(group_points_);
}

void ContactPatches::merge_remaining_pairs(const std::vector<ContactPoint>& points,
                                           std::span<const Vec3> normals_in_body) {
  if (group_points_.empty()) list_group_points(points);
  for (const PointInGroup& on : group_points_) {
    for (std::uint32_t j = on.before; j != kNoFeature; j = group_points_[j].before) {
      const std::uint32_t earlier = group_points_[j].point;
      if (find_patch_root(on.point) != find_patch_root(earlier) &&
          are_in_one_patch({on.point, earlier, on.group}, points, normals_in_body)) {
        merge_patches(on.point, earlier);
      }
    }
  }
}

bool ContactPatches::are_in_one_patch(const ContactPointPair& pair,
                                      const std::vector<ContactPoint>& points,
                                      std::span<const Vec3> normals_in_body) const {
  const ContactPoint &point = points[pair.point], &earlier = points[pair.earlier];
  if (is_side_wall(pair.group, normals_in_body[pair.point])) return false;
  return on_one_face(point, earlier) || (!is_side_wall(pair.group, normals_in_body[pair.earlier]) &&
                                         smooth_between(point, earlier));
}

void ContactPatches::merge_patches(std::uint32_t point, std::uint32_t other) {
  const std::uint32_t a = find_patch_root(point), b = find_patch_root(other);
  patch_[std::max(a, b)] = std::min(a, b);
}

bool ContactPatches::is_side_wall(std::uint32_t group, const Vec3& normal_in_body) const {
  return group < block_.faces.size() &&
         block_.faces[group].normal.dot(normal_in_body) > -kFacingCosine;
}

std::uint32_t ContactPatches::find_patch_root(std::uint32_t point) {
  while (patch_[point] != point) point = patch_[point] = patch_[patch_[point]];
  return point;
}

}  // namespace clast::dem_detail
