#pragma once
/// The faces that heaps settle behind.
#include <span>
#include <vector>

#include "dem/simulation/sequence.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

struct ConfiningWalls {
  std::vector<RigidBody> shapes;    ///< one to each form
  std::vector<SequenceForm> confining_walls;  ///< `shape` counts in `shapes`
};

/// Upright boxes on the sides of the polygons of masses that settle, from below the ground to above
/// the heap, so far out that no block of the heap reaches into them at its start: a fraction of a
/// cell of the packing. They close at the corners.
/// @param runs  of one realisation, mass by mass
ConfiningWalls build_confining_walls(const CampaignPlan& prepared, std::span<const RunRecord> runs);

}  // namespace clast::study_detail
