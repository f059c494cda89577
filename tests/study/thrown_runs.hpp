#pragma once
/// Results with trajectories that are known in closed form.
#include "study/results/results.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/gravity.hpp"

namespace clast {

/// Thrown at 10 m/s from 2 m above a level ground, spinning at 2 rad/s about z, seen four times a
/// second.
/// @param along  level, of length 1
inline Trajectory thrown(double seconds, const Vec3& along = Vec3::UnitX()) {
  Trajectory trajectory;
  for (double t = 0.0; t <= seconds; t += 0.25) {
    RigidState state;
    state.position = 10.0 * t * along + Vec3(0.0, 0.0, 2.0 - 0.5 * kTestGravity * t * t);
    state.velocity = 10.0 * along - Vec3(0.0, 0.0, kTestGravity * t);
    state.angular_velocity = Vec3(0.0, 0.0, 2.0);
    trajectory.time.push_back(t);
    trajectory.states.push_back(state);
  }
  return trajectory;
}

/// Two runs of the hand-made campaign, for half and for a quarter of a second. The first block is a
/// rounded cuboid of twice the library block's size.
inline void store_thrown(const std::filesystem::path& file, const Vec3& along = Vec3::UnitX()) {
  CampaignResults header = hand_made_results();
  header.release_sets = {""};
  header.set_of_point = {0};
  header.ground_sets = {{"", 0, header.ground}};
  header.shapes[0] = make_sphero_polyhedron(cuboid(0.4, 0.3, 0.2), 0.05);
  header.blocks[0].scale = 2.0;
  header.blocks[0].moments = Vec3(1.0, 2.0, 3.0);
  const std::vector<RunRecord> runs = header.runs;
  header.planned_runs = 2;
  {
    ResultsWriter writer = ResultsWriter::create(file, header);
    for (std::uint32_t i = 0; i < 2; ++i) {
      StoredRun run;
      run.record = runs[i];
      run.record.start.position = Vec3(0.0, 0.0, 2.0);
      run.trajectory = thrown(i == 0 ? 0.5 : 0.25, along);
      writer.add(run);
    }
    writer.finish();
  }
}

}  // namespace clast
