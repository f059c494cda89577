#include "dem/detail/contact_patches.hpp"

#include <algorithm>
#include <numeric>

namespace clast {
namespace {

/// Normals within a patch differ by at most 30 degrees: smoothly curved, not a ridge.
constexpr double kPatchCosine = 0.8660254037844386;
/// How far a point of a patch may stand above the tangent plane of another, as a sine: 3 degrees.
/// More is a valley, and its two sides carry the block apart.
constexpr double kPatchRise = 0.052;
/// A plane of the block joins contact points when it faces the ground within 60 degrees.
constexpr double kFacingCosine = 0.5;

}  // namespace

std::span<const double> ContactPatches::share(const std::vector<ContactPoint>& points,
                                              const Quat& orientation) {
  const std::size_t count = points.size();
  share_.assign(count, weights_ == ContactWeights::kCount ? 1.0 / static_cast<double>(count) : 1.0);
  law_.assign(count, 0);
  if (weights_ == ContactWeights::kNone) std::iota(law_.begin(), law_.end(), std::size_t{0});
  if (weights_ == ContactWeights::kNone || weights_ == ContactWeights::kCount) return share_;
  if (weights_ == ContactWeights::kPatch) join(points, orientation);
  law_overlap_.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) law_overlap_[law_of(i)] += points[i].overlap;
  for (std::size_t i = 0; i < count; ++i) share_[i] = points[i].overlap / law_overlap_[law_of(i)];
  return share_;
}

std::size_t ContactPatches::law_of(std::size_t point) {
  while (law_[point] != point) point = law_[point] = law_[law_[point]];
  return point;
}

std::span<const std::uint32_t> ContactPatches::joints_of(
    const ContactPoint& point, std::array<std::uint32_t, 3>& buffer) const {
  if (point.kind == ContactKind::kVertexGround) return block_.joints_of(point.block_feature);
  if (point.kind == ContactKind::kFaceVertex) {
    buffer[0] = block_.faces[point.block_feature].plane;
    return {buffer.data(), 1};
  }
  const SurfaceEdge& edge = block_.edges[point.block_feature];
  std::size_t count = 0;
  buffer[count++] = block_.joint_of_line(edge.line);
  for (const std::uint32_t face : edge.faces) {
    if (face != kNoFeature) buffer[count++] = block_.faces[face].plane;
  }
  return {buffer.data(), count};
}

void ContactPatches::join(const std::vector<ContactPoint>& points, const Quat& orientation) {
  // Flat or smoothly convex ground between the two.
  const auto smooth_between = [](const ContactPoint& a, const ContactPoint& b) {
    if (a.normal.dot(b.normal) < kPatchCosine) return false;
    const Vec3 between = b.foot - a.foot;
    const double rise = kPatchRise * between.norm();
    return a.normal.dot(between) <= rise && b.normal.dot(between) >= -rise;
  };
  law_.resize(points.size());
  std::iota(law_.begin(), law_.end(), std::size_t{0});
  on_joint_.resize(block_.faces.size() + block_.edges.size());
  const Mat3 body_from_world = orientation.toRotationMatrix().transpose();
  std::array<std::uint32_t, 3> buffer;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 in_body = body_from_world * points[i].normal;
    for (const std::uint32_t joint : joints_of(points[i], buffer)) {
      // A side wall joins nothing that stands on the ground: two feet stay two.
      const bool wall =
          joint < block_.faces.size() && block_.faces[joint].normal.dot(in_body) > -kFacingCosine;
      if (wall) continue;
      if (on_joint_[joint].empty()) joints_used_.push_back(joint);
      for (const std::uint32_t j : on_joint_[joint]) {
        const std::size_t a = law_of(i), b = law_of(j);
        if (a == b || !smooth_between(points[i], points[j])) continue;
        law_[std::max(a, b)] = std::min(a, b);
      }
      on_joint_[joint].push_back(i);
    }
  }
  for (const std::uint32_t joint : joints_used_) on_joint_[joint].clear();
  joints_used_.clear();
}

}  // namespace clast
