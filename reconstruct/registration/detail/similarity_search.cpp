#include "reconstruct/registration/detail/similarity_search.hpp"

#include <algorithm>

#include "reconstruct/registration/detail/disagreement.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kSmallestScale = 0.7, kLargestScale = 1.45, kScaleStep = 1.09;
constexpr std::size_t kPosesPerScale = 4;

}  // namespace

std::vector<PoseCandidate> search_similarities(const SampledSurface& fixed,
                                               const SampledSurface& moving, unsigned threads) {
  std::vector<PoseCandidate> found;
  for (double scale = kSmallestScale; scale < kLargestScale; scale *= kScaleStep) {
    const SampledSurface resized(scaled(moving.surface, scale));
    std::vector<PoseCandidate> poses = search_poses(fixed, resized, threads);
    if (poses.size() > kPosesPerScale) poses.resize(kPosesPerScale);
    for (PoseCandidate& one : poses) {
      one.fixed_from_moving.scale = scale;
      const ScaleEstimate estimate =
          estimate_scale({{&fixed, {}}}, {&moving, one.fixed_from_moving});
      one.fixed_from_moving = estimate.first_from_surface;
      one.agreement = estimate.agreement;
      found.push_back(one);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const PoseCandidate& a, const PoseCandidate& b) {
    return a.agreement.score > b.agreement.score;
  });
  return found;
}

}  // namespace clast::reconstruct_detail
