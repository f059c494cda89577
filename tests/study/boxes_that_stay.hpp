#pragma once
/// Realisations of boxes that lie on level ground.
#include "tests/study/hand_made_results.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {

/// Two realisations of three boxes of 2 m x 1 m x 0.5 m, which stay on a plane at z = 0.
inline CampaignResults boxes_that_stay() {
  CampaignResults results = hand_made_results();
  results.terrain.surface = plane_mesh(40.0, 4);
  results.terrain.zone.assign(results.terrain.surface.triangles.size(), 0);
  results.shapes.assign(results.shapes.size(), box(1.0, {2.0, 1.0, 0.5}).shape);
  results.persistent_blocks = {3, {0.01, 0.5, 0.3}};
  results.planned_runs = 6;
  results.persistent_block_records.clear();
  for (BlockSummary& block : results.blocks) {
    block.scale = 1.0;
    block.volume = 1.0;
    block.mass = 2000.0;
    block.axes = {2.0, 1.0, 0.5};
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    RunRecord& run = results.runs[i];
    results.persistent_block_records.push_back({.run = run.run});
    run.start = {};
    run.start.position = {-10.0, 0.0, 8.0 + i % 3};
    run.result.stop_reason = StopReason::kRest;
    run.result.final_state = {};
    run.result.final_state.position = {4.0 * (i % 3), 0.0, 0.25};
  }
  return results;
}

}  // namespace clast
