#pragma once
/// Results with a value of its own in every field, and their way into a file.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/random.hpp"
#include "core/version.hpp"
#include "study/results/results.hpp"
#include "study/results/results_journal.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {

inline CampaignResults sample_header() {
  CampaignResults header;
  header.campaign_text = "[blocks]\nlibrary = \"b.h5\"\n";
  header.campaign_sha256 = std::string(64, 'a');
  header.inputs = {"some folder/b.h5 " + std::string(64, 'b'), "t.stl " + std::string(64, 'c')};
  header.program_version = version();
  header.blocks = {{"B1", 343.68, {1.1, 0.9, 0.5}, "compact", "CB", "blade"},
                   {"B2",
                    514.14,
                    {2.1, 0.9, 0.5},
                    "elongated",
                    "E",
                    "rod",
                    "B",
                    "hard",
                    1.25,
                    0.2,
                    1,
                    {3, 4, 5}}};
  header.shapes.resize(2);
  header.shapes[0].vertices = {{0, 0, 0}};
  header.shapes[1] = make_sphero_polyhedron(cuboid(2.9, 1.9, 0.9), 0.05);
  header.barriers = {{"EC11", {{25, -400}, {25, -340}}},
                     {"EC12", {{36, -400}, {36, -370}, {40, -340}}, CountedDirection::kForward}};
  header.release_points = {{1, 2, 3}, {4, 5, 6}};
  header.release_sets = {"crest", "bench"};
  header.set_of_point = {0, 1};
  header.zone_names = {"blue", "gray"};
  header.ground = {{0.01, 0.7, 0.35, 0.12}, {0.04, 0.3, 0.0}};
  header.ground[0].slip_growth = 3.0;
  header.ground[0].scar_drag = 1.5;
  header.ground[0].soil_density = 1800.0;
  header.ground[0].soil_memory = 0.2;
  header.ground_sets = {{"", 0, header.ground}, {"hard", 1, {{0.02, 0.6, 0.3}, {0.05, 0.2, 0.1}}}};
  header.law = SpringDashpotLaw{};
  header.weighting = ContactWeighting::kOverlap;
  header.warnings = {"mind the gap"};
  header.downslope = Vec2(1.0, 0.25);
  header.terrain.surface.vertices = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0.25}, {0, 1, 0}};
  header.terrain.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  header.terrain.zone = {1, 0};
  header.terrain.zone_names = header.zone_names;
  header.terrain.report.notes = {"2 triangles turned"};
  header.terrain.sources = {"t.stl " + std::string(64, 'c')};
  header.terrain.frame = {Vec3(888600, 6671300, 0), "EPSG:2154"};
  header.frame = header.terrain.frame;
  header.planned_runs = 8;
  return header;
}

inline RigidState random_state(Random& random) {
  const auto vector = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  RigidState state;
  state.position = vector();
  state.orientation = random.rotation();
  state.velocity = vector();
  state.angular_velocity = vector();
  return state;
}

// A run with a value of its own in every field.
inline StoredRun sample_run(std::uint32_t number) {
  Random random(number);
  StoredRun run;
  run.record.run = number;
  run.record.block = number % 2;
  run.record.point = number / 4;
  run.record.orientation = number % 4;
  run.record.ground_set = number / 2 % 2;
  run.record.start = random_state(random);
  ReleaseResult& result = run.record.result;
  result.stop_reason = static_cast<StopReason>(number % 4);
  result.message = result.stop_reason == StopReason::kError ? "the sky fell (Gallien, -335)" : "";
  result.final_state = random_state(random);
  for (double* value : {&result.duration,
                        &result.path_length,
                        &result.max_speed,
                        &result.max_penetration,
                        &result.settled_penetration,
                        &result.energy.initial,
                        &result.energy.final,
                        &result.energy.normal,
                        &result.energy.friction,
                        &result.energy.rolling,
                        &result.energy.reassigned,
                        &result.energy.error,
                        &run.record.contacts.contact_time,
                        &run.record.contacts.mean_contact_points,
                        &run.record.contacts.longest_flight,
                        &run.record.contacts.max_energy,
                        &run.record.contacts.max_spin,
                        &run.record.stiffness.normal,
                        &run.record.stiffness.tangential,
                        &run.record.stiffness.rolling,
                        &run.record.stiffness.time_step,
                        &run.record.settled_depth,
                        &run.record.impact_depth}) {
    *value = random.normal();
  }
  result.below_ground = number % 3 == 0;
  result.contact_steps = 5'000'000'000ULL + number;
  result.impacts = number;
  run.record.contacts.max_contact_points = 7 + number;
  for (std::uint32_t i = 0; i < number % 4; ++i) {
    Impact impact;
    impact.run = number;
    impact.zone = i % 2;
    impact.position = Vec3(random.normal(), random.normal(), random.normal());
    for (double* value :
         {&impact.time, &impact.contact_duration, &impact.speed_before, &impact.speed_after,
          &impact.translational_before, &impact.translational_after, &impact.rotational_before,
          &impact.rotational_after, &impact.depth}) {
      *value = random.uniform();
    }
    run.impacts.push_back(impact);
  }
  for (std::uint32_t i = 0; i < number % 3; ++i) {
    Crossing crossing;
    crossing.run = number;
    crossing.barrier = i;
    crossing.forward = i == 0;
    const RigidState state = random_state(random);
    crossing.position = state.position;
    crossing.velocity = state.velocity;
    crossing.angular_velocity = state.angular_velocity;
    for (double* value : {&crossing.time, &crossing.height, &crossing.clearance,
                          &crossing.translational_energy, &crossing.rotational_energy}) {
      *value = random.uniform();
    }
    run.crossings.push_back(crossing);
  }
  for (std::uint32_t i = 0; i < 50 + number; ++i) {
    run.trajectory.time.push_back(0.1 * i);
    run.trajectory.states.push_back(random_state(random));
  }
  return run;
}

inline void add_run(ResultsWriter& writer, std::uint32_t number) {
  const StoredRun run = sample_run(number);
  writer.add(run);
}

// That the file holds the sample runs `numbers` (sorted), whole.
inline void expect_runs(const std::filesystem::path& file,
                        const std::vector<std::uint32_t>& numbers) {
  const CampaignResults results = read_results(file);
  ASSERT_EQ(results.runs.size(), numbers.size());
  std::size_t crossing = 0, impact = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const StoredRun run = sample_run(numbers[i]);
    expect_equal(results.runs[i], run.record);
    for (const Crossing& expected : run.crossings) {
      ASSERT_LT(crossing, results.crossings.size());
      expect_equal(results.crossings[crossing++], expected);
    }
    for (const Impact& expected : run.impacts) {
      ASSERT_LT(impact, results.impacts.size());
      expect_equal(results.impacts[impact++], expected);
    }
    expect_equal(read_trajectory(file, numbers[i]), run.trajectory);
  }
  EXPECT_EQ(crossing, results.crossings.size());
  EXPECT_EQ(impact, results.impacts.size());
}

}  // namespace clast
