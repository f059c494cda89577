#include "reconstruct/registration/detail/scan_group.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reconstruct/registration/detail/joint_refinement.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kGroupSteps = 15;
/// Fractions of a surface that may differ between two poses of the same body.
constexpr double kMaxContradicted = 0.02, kMaxUncovered = 0.06;

double tolerance_of(const SampledSurface& a, const SampledSurface& b) {
  return fine_tolerance(a.surface, b.surface, std::min(a.diagonal, b.diagonal));
}

}  // namespace

SurfaceAgreement compare_with_group(const ScanGroup& group, const PlacedSurface& added) {
  SurfaceAgreement sum;
  double squares = 0.0;
  for (const PlacedSurface& member : group) {
    const SurfaceAgreement one = compare_surfaces(
        *member.sampled, *added.sampled, member.first_from.inverse() * added.first_from,
        tolerance_of(*member.sampled, *added.sampled), PointDensity::kAll);
    sum.matched += one.matched;
    sum.contradicted += one.contradicted;
    sum.score += one.score;
    squares += one.matched * one.deviation * one.deviation;
    sum.misfit += (one.matched + one.contradicted) * one.misfit;
  }
  if (sum.matched > 0.0) sum.deviation = std::sqrt(squares / sum.matched);
  if (sum.matched + sum.contradicted > 0.0) sum.misfit /= sum.matched + sum.contradicted;
  return sum;
}

PoseCandidate refine_in_group(const ScanGroup& group, const PlacedSurface& added) {
  std::vector<const SampledSurface*> surfaces;
  std::vector<Similarity> poses;
  double tolerance = 0.0;
  for (const PlacedSurface& member : group) {
    surfaces.push_back(member.sampled);
    poses.push_back(member.first_from);
    tolerance = std::max(tolerance, tolerance_of(*member.sampled, *added.sampled));
  }
  surfaces.push_back(added.sampled);
  poses.push_back(added.first_from);
  const Refinement refined =
      refine_jointly(surfaces, poses, {.tolerance = tolerance, .iterations = kGroupSteps});
  PoseCandidate candidate;
  candidate.fixed_from_moving = refined.first_from.back();
  candidate.free_movements = refined.free_movements;
  ScanGroup moved = group;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i].first_from = refined.first_from[i];
  candidate.agreement = compare_with_group(moved, {added.sampled, refined.first_from.back()});
  return candidate;
}

bool is_same_body(const ScanGroup& group, const SampledSurface& added, const Similarity& pose,
                  const Similarity& other) {
  const auto matches = [&](const SampledSurface& surface, const Similarity& surface_from_added,
                           std::uint32_t i) {
    return compare_point(surface, surface_from_added * added.surface.points[i],
                         surface_from_added.pose.rotation * added.surface.normals[i],
                         tolerance_of(surface, added))
        .relation;
  };
  const std::array<Similarity, 2> poses = {pose, other};
  for (std::size_t side = 0; side < 2; ++side) {
    const Similarity &here = poses[side], &there = poses[1 - side];
    std::size_t contradicted = 0, uncovered = 0;
    for (std::uint32_t i = 0; i < added.surface.size(); ++i) {
      const PointRelation own = matches(added, there.inverse() * here, i);
      contradicted += own == PointRelation::kContradicted;
      if (own != PointRelation::kUnobserved) continue;
      uncovered += std::none_of(group.begin(), group.end(), [&](const PlacedSurface& member) {
        return matches(*member.sampled, member.first_from.inverse() * here, i) ==
               PointRelation::kMatched;
      });
    }
    const auto count = static_cast<double>(added.surface.size());
    if (static_cast<double>(contradicted) > kMaxContradicted * count ||
        static_cast<double>(uncovered) > kMaxUncovered * count) {
      return false;
    }
  }
  return true;
}

}  // namespace clast::reconstruct_detail
