// The 3-D view: its data, and what is said where it can't be drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/scene/scene_section.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/packed_numbers.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

using Json = nlohmann::json;

/// The hand-made campaign with trajectories: run n slides from its start to its stop in n + 2 steps
/// of 0.5 s.
class Scene : public testing::Test {
 protected:
  Comparison stored() {
    CampaignResults results = hand_made_results();
    results.release_sets = {""};
    results.set_of_point = {0};
    results.ground_sets = {{"", 0, results.ground}};
    ResultsWriter writer = ResultsWriter::create(folder / "r.h5", results);
    for (const RunRecord& run : results.runs) {
      Trajectory way;
      const int steps = static_cast<int>(run.run) + 2;
      for (int k = 0; k <= steps; ++k) {
        RigidState state = run.start;
        const double share = static_cast<double>(k) / steps;
        state.position += share * (run.result.final_state.position - run.start.position);
        way.time.push_back(0.5 * k);
        way.states.push_back(state);
      }
      StoredRun stored_run;
      stored_run.record = run;
      stored_run.trajectory = way;
      writer.add(stored_run);
    }
    writer.finish();
    return compared(read_results(folder / "r.h5"));
  }
  ScratchFolder folder;
};

TEST_F(Scene, HoldsEveryStateOnTheMapLessItsOrigin) {
  const Comparison comparison = stored();
  const SceneData scene = make_scene_data(comparison);
  EXPECT_EQ(scene.runs_drawn, comparison.rows.size());
  EXPECT_EQ(scene.runs, comparison.rows.size());
  const Json json = Json::parse(scene.json);
  const std::vector<float> frames = packed_numbers<float>(json["frames"]);
  const Vec3 origin(json["origin"][0], json["origin"][1], json["origin"][2]);
  ASSERT_EQ(json["runs"].size(), comparison.rows.size());
  std::size_t total = 0;
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const RunRow& row = comparison.rows[i];
    const Json& run = json["runs"][i];
    EXPECT_EQ(run["first"], total);
    EXPECT_EQ(run["count"], row.record->run + 3);
    EXPECT_EQ(run["body"], row.record->block);
    total += run["count"].get<std::size_t>();
    const float* last = &frames[8 * (total - 1)];
    EXPECT_EQ(last[0], 0.5f * static_cast<float>(row.record->run + 2));
    EXPECT_LT((Vec3(last[1], last[2], last[3]) + origin - row.stop).norm(), 1e-4);
    EXPECT_NEAR(std::hypot(last[4], last[5], std::hypot(last[6], last[7])), 1.0, 1e-4);
  }
  EXPECT_EQ(frames.size(), 8 * total);
  EXPECT_EQ(json["duration"], 0.5 * (comparison.rows.back().record->run + 2));
}

TEST_F(Scene, HoldsTheRealShapesAndTheGround) {
  const Comparison comparison = stored();
  const Json json = Json::parse(make_scene_data(comparison).json);
  ASSERT_EQ(json["bodies"].size(), 2u);
  const std::vector<float> box = packed_numbers<float>(json["bodies"][1]["vertices"]);
  ASSERT_EQ(box.size(), 3u * 8u);
  float longest = 0.0f;
  for (std::size_t i = 0; i < box.size(); i += 3) longest = std::max(longest, box[i]);
  EXPECT_EQ(longest, 1.0f);  // half of L = 2
  EXPECT_EQ(json["bodies"][1]["group"], "elongated");
  const Terrain& terrain = comparison.results[0].terrain;
  EXPECT_EQ(packed_numbers<std::uint32_t>(json["terrain"]["triangles"]).size(),
            3 * terrain.surface.triangles.size());
  EXPECT_EQ(packed_numbers<std::uint16_t>(json["terrain"]["zones"]), terrain.zone);
  EXPECT_EQ(json["tints"].size(), comparison.results[0].zone_names.size());
  EXPECT_EQ(json["barriers"].size(), comparison.lines.size());
}

TEST_F(Scene, ThinsRunsAndGroundToItsLimits) {
  const Comparison comparison = stored();
  const SceneData whole = make_scene_data(comparison);
  const std::size_t frames = packed_numbers<float>(Json::parse(whole.json)["frames"]).size() / 8;
  const SceneData half = make_scene_data(comparison, {.frames = (frames + 1) / 2});
  EXPECT_EQ(half.runs_drawn, (whole.runs_drawn + 1) / 2);
  EXPECT_EQ(half.runs, whole.runs);
  const Json coarse =
      Json::parse(make_scene_data(comparison, {.triangles = 1, .grid = 12}).json)["terrain"];
  const std::size_t triangles = packed_numbers<std::uint32_t>(coarse["triangles"]).size() / 3;
  EXPECT_GT(triangles, 0u);
  EXPECT_EQ(packed_numbers<std::uint16_t>(coarse["zones"]).size(), triangles);
  // The slope is z = -x / 2 on the map, so it is in the grid.
  const Json full = Json::parse(whole.json);
  const double x0 = double(full["origin"][0]) - kMapOrigin.x(),
               z0 = double(full["origin"][2]) - kMapOrigin.z();
  const std::vector<float> vertices = packed_numbers<float>(coarse["vertices"]);
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    EXPECT_NEAR(vertices[i + 2] + z0, -0.5 * (vertices[i] + x0), 1e-3);
  }
  EXPECT_THROW(make_scene_data(comparison, {.frames = 0}), InputError);
  EXPECT_THROW(make_scene_data(comparison, {.grid = 1}), InputError);
}

TEST_F(Scene, IsOnePieceOfThePageAndSaysHowManyRunsItDraws) {
  const Comparison comparison = stored();
  const std::string all = format_scene_section(comparison);
  EXPECT_TRUE(contains(all, "All " + std::to_string(comparison.rows.size()) + " runs are drawn."));
  EXPECT_EQ(unbalanced(all), "");
  // What three.js says of itself in comments is not looked at.
  expect_self_contained(all.substr(0, all.find("<script>")));
  EXPECT_TRUE(contains(format_scene_section(comparison, {.frames = 1}),
                       "1 of " + std::to_string(comparison.rows.size()) + " runs are drawn"));
}

TEST_F(Scene, SaysWhatIsMissing) {
  EXPECT_TRUE(contains(format_scene_section(compared(hand_made_results())),
                       "The results contain no trajectories; set [run] trajectory_interval_s"));
  ASSERT_EQ(::setenv("CLAST_THREE", folder.path().c_str(), 1), 0);
  const std::string none = format_scene_section(stored());
  ::unsetenv("CLAST_THREE");
  EXPECT_TRUE(contains(none, "three.js is not in " + folder.path().string()));
  EXPECT_TRUE(contains(none, "apt install libjs-three"));
}

}  // namespace
}  // namespace clast
