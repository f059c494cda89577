#include "reconstruct/registration/detail/pose_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/registration/detail/joint_refinement.hpp"
#include "reconstruct/registration/detail/rotation_search.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Tolerances of the stages, relative to the smaller diagonal.
constexpr double kCoarse = 0.05, kMedium = 0.03, kClose = 0.02, kFine = 0.015;
constexpr std::size_t kGlanced = 8000;   ///< poses left after a comparison of few points
constexpr std::size_t kScored = 2000;    ///< poses that are refined roughly with even subsets
constexpr std::size_t kPromising = 400;  ///< poses that are refined well with even subsets
constexpr std::size_t kRefined = 40;     ///< distinct poses that are refined with all points
/// Distances below which poses count as one, relative to the smaller diagonal.
constexpr double kSearchDistance = 0.1, kDistinct = 0.06;
constexpr int kFirstSteps = 4, kSparseSteps = 8, kFullSteps = 12;
constexpr double kToleratedNoises = 2.5, kLeastTolerance = 0.006;

void keep_best(std::vector<PoseCandidate>& candidates, std::size_t count) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const PoseCandidate& a, const PoseCandidate& b) {
                     return a.agreement.score > b.agreement.score;
                   });
  if (candidates.size() > count) candidates.resize(count);
}

/// Keeps the best of poses that are near each other.
std::vector<PoseCandidate> distinct_poses(std::vector<PoseCandidate> candidates,
                                          const SampledSurface& moving, double distance,
                                          std::size_t count) {
  keep_best(candidates, candidates.size());
  Bounds box;
  for (const Vec3& p : moving.surface.points) box.include(p);
  const Vec3 centre = 0.5 * (box.low + box.high);
  std::vector<PoseCandidate> kept;
  for (const PoseCandidate& candidate : candidates) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const PoseCandidate& other) {
      return are_near(candidate.fixed_from_moving, other.fixed_from_moving, centre,
                      0.5 * moving.diagonal, distance);
    });
    if (!known) kept.push_back(candidate);
    if (kept.size() == count) break;
  }
  return kept;
}

void refine(PoseCandidate& candidate, const SampledSurface& fixed, const SampledSurface& moving,
            double tolerance, int steps, PointDensity density) {
  const std::array<const SampledSurface*, 2> both = {&fixed, &moving};
  const Refinement refined =
      refine_jointly(both, {Similarity{}, candidate.fixed_from_moving},
                     {.tolerance = tolerance, .iterations = steps, .density = density});
  candidate.fixed_from_moving = refined.first_from[1];
  candidate.free_movements = refined.free_movements;
}

void refine_sparse(std::vector<PoseCandidate>& candidates, const SampledSurface& fixed,
                   const SampledSurface& moving, double tolerance, int steps, unsigned threads) {
  parallel_for(candidates.size(), threads, [&](std::size_t i) {
    refine(candidates[i], fixed, moving, tolerance, steps, PointDensity::kSparse);
  });
}

void score(std::vector<PoseCandidate>& candidates, const SampledSurface& fixed,
           const SampledSurface& moving, double tolerance, PointDensity density, unsigned threads) {
  constexpr std::size_t kPerTask = 256;
  parallel_for((candidates.size() + kPerTask - 1) / kPerTask, threads, [&](std::size_t task) {
    const std::size_t end = std::min(candidates.size(), (task + 1) * kPerTask);
    for (std::size_t i = task * kPerTask; i < end; ++i) {
      candidates[i].agreement =
          compare_surfaces(fixed, moving, candidates[i].fixed_from_moving, tolerance, density);
    }
  });
}

}  // namespace

double fine_tolerance(const OrientedSurface& a, const OrientedSurface& b, double diagonal) {
  return std::max(kToleratedNoises * std::hypot(a.noise, b.noise), kLeastTolerance * diagonal);
}

bool are_near(const Similarity& a, const Similarity& b, const Vec3& centre, double radius,
              double distance) {
  const Quat between = a.pose.rotation.conjugate() * b.pose.rotation;
  const double turn = 2.0 * std::asin(std::min(1.0, between.vec().norm()));
  return (a * centre - b * centre).norm() + radius * turn < distance;
}

PoseCandidate refine_near_pose(const SampledSurface& fixed, const SampledSurface& moving,
                               const Similarity& fixed_from_moving) {
  const double size = std::min(fixed.diagonal, moving.diagonal);
  const double fine = fine_tolerance(fixed.surface, moving.surface, size);
  PoseCandidate candidate;
  candidate.fixed_from_moving = fixed_from_moving;
  for (const double tolerance : {kCoarse * size, kMedium * size, kFine * size, fine}) {
    refine(candidate, fixed, moving, std::max(tolerance, fine), kFullSteps, PointDensity::kAll);
  }
  candidate.agreement =
      compare_surfaces(fixed, moving, candidate.fixed_from_moving, fine, PointDensity::kAll);
  return candidate;
}

std::vector<PoseCandidate> search_poses(const SampledSurface& fixed, const SampledSurface& moving,
                                        unsigned threads) {
  const double size = std::min(fixed.diagonal, moving.diagonal);
  const std::vector<Pose> poses = search_rotations(fixed, moving, threads);
  std::vector<PoseCandidate> candidates(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) candidates[i].fixed_from_moving = {poses[i], 1.0};
  score(candidates, fixed, moving, kCoarse * size, PointDensity::kFew, threads);
  keep_best(candidates, kGlanced);
  score(candidates, fixed, moving, kCoarse * size, PointDensity::kSparse, threads);
  candidates = distinct_poses(std::move(candidates), moving, kSearchDistance * size, kScored);
  refine_sparse(candidates, fixed, moving, kCoarse * size, kFirstSteps, threads);
  score(candidates, fixed, moving, kMedium * size, PointDensity::kSparse, threads);
  candidates =
      distinct_poses(std::move(candidates), moving, 0.5 * kSearchDistance * size, kPromising);
  refine_sparse(candidates, fixed, moving, kMedium * size, kSparseSteps, threads);
  score(candidates, fixed, moving, kClose * size, PointDensity::kSparse, threads);
  candidates = distinct_poses(std::move(candidates), moving, kDistinct * size, kRefined);
  const double fine = fine_tolerance(fixed.surface, moving.surface, size);
  parallel_for(candidates.size(), threads, [&](std::size_t i) {
    PoseCandidate& one = candidates[i];
    refine(one, fixed, moving, std::max(fine, kFine * size), kFullSteps, PointDensity::kAll);
    refine(one, fixed, moving, fine, kFullSteps, PointDensity::kAll);
    one.agreement =
        compare_surfaces(fixed, moving, one.fixed_from_moving, fine, PointDensity::kAll);
  });
  return distinct_poses(std::move(candidates), moving, 0.5 * kDistinct * size, kRefined);
}

}  // namespace clast::reconstruct_detail
