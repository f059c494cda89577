#pragma once
/// Confining walls of multi-block releases whose blocks settle before the release.
#include <span>
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

struct ConfiningWalls {
  std::vector<RigidBody> shapes;               ///< one per wall
  std::vector<ConfiningWall> confining_walls;  ///< `shape` is an index into `shapes`
};

/// Builds vertical boxes on the sides of the polygons, from below the ground to above the heap.
/// They are joined at the corners. They are moved outwards by a fraction of a packing cell, so that
/// no block overlaps them at the start.
/// @param runs  runs of one realisation, ordered by release
ConfiningWalls build_confining_walls(const CampaignPlan& prepared, std::span<const RunRecord> runs);

}  // namespace clast::study_detail
