#pragma once
/// A small campaign written by hand: two blocks of different class on a slope with two zones.
#include <string>

#include "study/compare/comparison.hpp"
#include "study/results/results.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {

inline const Vec3 kMapOrigin(900000.0, 6500000.0, 200.0);

/// A run that starts over the local origin and stops at (x, y) on the slope z = -x / 2.
inline RunRecord hand_made_run(std::uint32_t run, std::uint32_t block, double x, double y) {
  RunRecord record;
  record.run = run;
  record.block = block;
  record.point = 0;
  record.orientation = run;
  record.start.position = Vec3(0.0, 0.0, 2.0);
  // Turned differently each time, so that no orientation repeats.
  record.start.orientation = Quat(Eigen::AngleAxisd(0.1 * run, Vec3::UnitZ()));
  record.result.stop_reason = StopReason::kRest;
  record.result.duration = 5.0 + run;
  record.result.final_state.position = Vec3(x, y, -0.5 * x);
  record.result.path_length = 1.2 * x;
  record.result.max_speed = 8.0 + run;
  record.result.max_penetration = 0.01;
  record.result.settled_penetration = 0.002;
  record.result.energy.error = 1e-5 * (run + 1);
  record.result.contact_steps = 1000 + run;
  // The second block's own, and another in its last run.
  record.stiffness = block == 0 ? ContactStiffness{1e8, 1e8, 1e7, 2e-5}
                                : ContactStiffness{(run == 5 ? 4e8 : 3e8), 3e8, 2e7, 1e-5};
  record.settled_depth = block == 0 ? 0.012 : 0.016;
  record.impact_depth = 0.1;
  return record;
}

inline Crossing hand_made_crossing(std::uint32_t run, std::uint32_t barrier, double time,
                                   double speed) {
  Crossing crossing;
  crossing.run = run;
  crossing.barrier = barrier;
  crossing.time = time;
  crossing.position = Vec3(10.0, 0.0, -4.0);
  crossing.velocity = Vec3(0.0, 0.6 * speed, -0.8 * speed);
  crossing.angular_velocity = Vec3(0.0, 3.0, 4.0);
  crossing.height = 1.0;
  crossing.clearance = 0.25;
  crossing.translational_energy = 150.0 * speed * speed;
  crossing.rotational_energy = 50.0;
  return crossing;
}

/// Six runs: four of the compact block straight down to x = 10, 20, 30, 40 m; two of the elongated
/// one to (10, -10), which is 45 degrees to the right, and (20, 20), 45 degrees to the left.
/// Barrier "B<1>" at x = 10 m faces downslope, "B2" at x = 35 m too.
inline CampaignResults hand_made_results() {
  CampaignResults results;
  results.file = "hand-made.h5";
  results.campaign_text = "[blocks]\nlibrary = \"blocks.h5\"  # a < b & c\n";
  results.campaign_sha256 = std::string(64, 'c');
  results.inputs = {"blocks.h5 " + std::string(64, 'b'), "slope.stl " + std::string(64, 'a')};
  results.program_version = "0.1.0";
  results.blocks = {{"round<1>", 300.0, {1.0, 0.9, 0.8}, "compact", "C", "spheroid"},
                    {"long, \"2\"", 500.0, {2.0, 1.0, 0.9}, "elongated", "VE", "rod"}};
  for (BlockSummary& block : results.blocks) {
    const Vec3 sides(block.axes.L, block.axes.I, block.axes.S);
    TriangleMesh box = box_mesh(sides);
    for (Vec3& vertex : box.vertices) vertex -= 0.5 * sides;
    block.shape = static_cast<std::uint32_t>(results.shapes.size());
    results.shapes.push_back(make_sphero_polyhedron(box, 0.0));
  }
  results.barriers = {{"B<1>", {Vec2(10.0, -20.0), Vec2(10.0, 20.0)}},
                      {"B2", {Vec2(35.0, -20.0), Vec2(35.0, 20.0)}}};
  results.release_points = {Vec3(0.0, 0.0, 2.0)};
  results.zone_names = {"blue", "scree"};
  results.ground = {{0.01, 0.7, 0.35}, {0.01, 0.3, 0.0}};
  results.frame.origin = kMapOrigin;
  results.downslope = Vec2(2.0, 0.0);
  results.planned_runs = 6;

  Terrain& terrain = results.terrain;
  for (const double x : {-10.0, 20.0, 60.0}) {
    for (const double y : {-30.0, 30.0}) terrain.surface.vertices.push_back({x, y, -0.5 * x});
  }
  terrain.surface.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  terrain.zone = {0, 0, 1, 1};
  terrain.zone_names = results.zone_names;
  terrain.frame = results.frame;

  results.runs = {hand_made_run(0, 0, 10.0, 0.0),   hand_made_run(1, 0, 20.0, 0.0),
                  hand_made_run(2, 0, 30.0, 0.0),   hand_made_run(3, 0, 40.0, 0.0),
                  hand_made_run(4, 1, 10.0, -10.0), hand_made_run(5, 1, 20.0, 20.0)};
  // Run 1 passes B<1>, comes back and passes again: one crossing counts.
  results.crossings = {hand_made_crossing(1, 0, 1.0, 2.0), hand_made_crossing(1, 0, 2.0, 9.0),
                       hand_made_crossing(1, 0, 3.0, 9.0), hand_made_crossing(2, 0, 1.5, 4.0),
                       hand_made_crossing(3, 0, 1.2, 6.0), hand_made_crossing(3, 1, 4.0, 5.0),
                       hand_made_crossing(5, 0, 1.1, 3.0)};
  results.crossings[1].forward = false;
  return results;
}

inline Comparison compared(CampaignResults results) {
  std::vector<CampaignResults> all;
  all.push_back(std::move(results));
  return compare(std::move(all));
}

inline Comparison compared(CampaignResults first, CampaignResults second) {
  std::vector<CampaignResults> all;
  all.push_back(std::move(first));
  second.campaign_sha256 = std::string(64, 'd');
  all.push_back(std::move(second));
  return compare(std::move(all));
}

}  // namespace clast
