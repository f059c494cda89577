#pragma once
/// Confining walls of multi-block releases whose blocks settle before the release.
#include <span>
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

struct ConfiningWalls {
  std::vector<RigidBody> shapes;               ///< shape of each wall
  std::vector<ConfiningWall> confining_walls;  ///< walls, whose `shape` is an index into `shapes`
};

/// Builds confining walls: vertical boxes on the sides of the outlines, from below the ground to
/// above the heap.
/// @param runs  runs of one realisation, ordered by release
ConfiningWalls build_confining_walls(const CampaignPlan& prepared, std::span<const RunRecord> runs);

}  // namespace clast::study_detail
