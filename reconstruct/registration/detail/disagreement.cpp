#include "reconstruct/registration/detail/disagreement.hpp"

#include <algorithm>
#include <cmath>

#include "reconstruct/registration/detail/joint_refinement.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Distance that noise and roughness explain: standard deviations of the noise of both scans, and a
/// fraction of the diagonal.
constexpr double kAgreeingNoises = 2.0, kRoughness = 0.006;
/// Distance beyond which a point is compared with another part of the surface, relative to the
/// diagonal.
constexpr double kComparedHeight = 0.04;
constexpr int kScaleSteps = 25;
/// Systematic error of an estimated scale, from the smoothing of both surfaces.
constexpr double kScaleBias = 5e-4;

}  // namespace

Disagreement measure_disagreement(const ScanGroup& group, const PlacedSurface& placed) {
  const SampledSurface& own = *placed.sampled;
  double overlapping = 0.0, apart = 0.0, squares = 0.0;
  for (std::uint32_t i = 0; i < own.surface.size(); ++i) {
    // The nearest of the surfaces that were observed there decides.
    double nearest = 1e300, limit = 0.0;
    for (const PlacedSurface& member : group) {
      const SampledSurface& other = *member.sampled;
      const Similarity to = member.first_from.inverse() * placed.first_from;
      const double searched = kComparedHeight * std::min(own.diagonal, other.diagonal);
      const PointComparison found = compare_point(
          other, to * own.surface.points[i], to.pose.rotation * own.surface.normals[i], searched);
      if (found.relation != PointRelation::kMatched) continue;
      if (std::abs(found.height) >= std::abs(nearest)) continue;
      nearest = found.height * member.first_from.scale;
      limit = std::max(kAgreeingNoises * std::hypot(own.surface.noise, other.surface.noise),
                       kRoughness * std::min(own.diagonal, other.diagonal));
    }
    if (nearest == 1e300) continue;
    overlapping += 1.0;
    if (std::abs(nearest) <= limit) continue;
    apart += 1.0;
    squares += nearest * nearest;
  }
  Disagreement found;
  found.overlap = overlapping / static_cast<double>(own.surface.size());
  if (overlapping > 0.0) found.fraction = apart / overlapping;
  if (apart > 0.0) found.distance = std::sqrt(squares / apart);
  return found;
}

double scale_error(double scale, double variance) {
  return scale * std::hypot(std::sqrt(variance), kScaleBias);
}

ScaleEstimate estimate_scale(const ScanGroup& group, const PlacedSurface& placed) {
  std::vector<const SampledSurface*> surfaces;
  std::vector<Similarity> poses;
  std::vector<bool> free;
  double tolerance = 0.0;
  for (const PlacedSurface& member : group) {
    surfaces.push_back(member.sampled);
    poses.push_back(member.first_from);
    free.push_back(false);
    tolerance = std::max(
        tolerance, fine_tolerance(member.sampled->surface, placed.sampled->surface,
                                  std::min(member.sampled->diagonal, placed.sampled->diagonal)));
  }
  surfaces.push_back(placed.sampled);
  poses.push_back(placed.first_from);
  free.push_back(true);
  // Poses are relative to the first of the group, which keeps its place.
  const Similarity back = poses[0].inverse();
  for (Similarity& pose : poses) pose = back * pose;
  poses[0] = {};
  for (const double wider : {4.0, 2.0, 1.0}) {
    poses = refine_jointly(
                surfaces, poses,
                {.tolerance = wider * tolerance, .iterations = kScaleSteps, .free_scale = free})
                .first_from;
  }
  const Refinement refined = refine_jointly(
      surfaces, poses, {.tolerance = tolerance, .iterations = kScaleSteps, .free_scale = free});
  ScaleEstimate estimate;
  estimate.scale = refined.first_from.back().scale;
  const Eigen::Index last = refined.covariance.rows() - 1;
  estimate.first_from_surface = refined.first_from.back();
  estimate.standard_error = scale_error(estimate.scale, refined.covariance(last, last));
  ScanGroup moved;
  for (std::size_t i = 0; i + 1 < surfaces.size(); ++i) {
    moved.push_back({surfaces[i], refined.first_from[i]});
  }
  estimate.agreement = compare_with_group(moved, {placed.sampled, refined.first_from.back()});
  return estimate;
}

}  // namespace clast::reconstruct_detail
