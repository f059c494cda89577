// Rock masses that settle behind faces before they are released.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "study/campaign/plan_polygon.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {
namespace {

class SettledMass : public CampaignRun {
 protected:
  /// Ten blocks in a heap on the slope.
  static std::string text(const std::string& keys = "settle = true\n") {
    return with_mass("[[mass]]\npolygon = [[-6, -1], [-4, -1], [-4, 1], [-6, 1]]\n" + keys, 10);
  }
  static std::string with_mass(const std::string& mass, int blocks) {
    std::string text = campaign_text();
    const std::size_t begin = text.find("[release]");
    text.replace(begin, text.find("[[barrier]]") - begin, mass);
    text = replaced_once(text, "[terrain]",
                         "draw = { count = " + std::to_string(blocks) + " }\n[terrain]");
    return replaced_once(text, "max_time_s = 6", "max_time_s = 20") +
           "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.2\n";
  }
  static CampaignResults run(const std::string& text, const std::string& file,
                             const CampaignRunOptions& options = {}) {
    run_campaign(prepared(text), *folder_ / file, options);
    return read_results(*folder_ / file);
  }
};

TEST_F(SettledMass, StartsWhereItsBlocksCameToRest) {
  const CampaignPlan plan = prepared(text());
  const CampaignResults results = run(text(), "settled.h5");
  double fallen = 0.0, moved = 0.0;
  for (const RunRecord& record : results.runs) {
    ASSERT_EQ(record.result.stop_reason, StopReason::kRest) << record.result.message;
    EXPECT_LT(record.result.energy.error, 1e-3);
    const Vec3 start = results.frame.to_map(record.start.position);
    EXPECT_GT(start.x(), -6.0);
    EXPECT_LT(start.x(), -4.0);
    EXPECT_LT(std::abs(start.y()), 1.0);
    EXPECT_LT(record.start.velocity.norm(), 0.05);
    fallen += plan.runs[record.run].start.position.z() - record.start.position.z();
    moved += (record.result.final_state.position - record.start.position).norm();
    const Trajectory path = read_trajectory(*folder_ / "settled.h5", record.run);
    EXPECT_EQ(path.time.front(), 0.0);
    EXPECT_LT((path.states.front().position - record.start.position).norm(), 1e-9);
    EXPECT_EQ(results.persistent_block_records[record.run].released_at, 0.0);
  }
  EXPECT_GT(fallen / 10.0, 0.05);
  EXPECT_GT(moved / 10.0, 0.5);  // the slope is steeper than a heap behind no face
}

TEST_F(SettledMass, IsTheSameOnThreadsAndInShards) {
  const std::string two = text("settle = true\nrealisations = 2\n");
  const CampaignResults whole = run(two, "whole.h5", {.threads = 1});
  const CampaignResults threads = run(two, "threads.h5", {.threads = 2});
  const CampaignResults wide = run(text(), "wide.h5", {.threads = 2});  // all for one realisation
  const CampaignPlan plan = prepared(two);
  const CampaignResults merged = run_in_shards(plan, 2);
  for (std::size_t i = 0; i < whole.runs.size(); ++i) {
    for (const CampaignResults* other : {&threads, &merged, &wide}) {
      if (i >= other->runs.size()) continue;
      expect_equal(whole.runs[i].start, other->runs[i].start);
      expect_equal(whole.runs[i].result.final_state, other->runs[i].result.final_state);
    }
  }
}

TEST_F(SettledMass, WaitsBehindItsFacesAndLosesThemOneByOne) {
  const auto last_moves = [&](const std::string& keys, const std::string& file) {
    const CampaignResults results = run(text("settle = true\n" + keys), file);
    double duration = 0.0;
    for (const RunRecord& record : results.runs) {
      EXPECT_EQ(record.result.stop_reason, StopReason::kRest) << record.result.message;
      EXPECT_LT(record.result.energy.error, 1e-3);
      duration = std::max(duration, record.result.duration);
    }
    return duration;
  };
  const double together = last_moves("faces = \"together\"\n", "together.h5");
  // The face downhill, from the second corner to the third, is the second to go.
  const double one_by_one = last_moves("faces = \"one by one\"\nface_interval_s = 5\n", "one.h5");
  EXPECT_GE(one_by_one, 15.0);
  EXPECT_GT(one_by_one, together + 3.0);
}

/// Share of solid at points inside a heap of cubes, away from its faces and its top.
double solid_inside(const std::vector<RigidState>& cubes, double half_cube, const Vec2& low,
                    const Vec2& high) {
  std::vector<double> heights;
  for (const RigidState& cube : cubes) heights.push_back(cube.position.z());
  std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(cubes.size() / 2),
                   heights.end());
  const double top = heights[cubes.size() / 2] + half_cube;
  Random random(3);
  std::size_t solid = 0;
  constexpr std::size_t kPoints = 40000;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Vec3 point(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()),
                     random.uniform(0.0, top));
    solid += std::any_of(cubes.begin(), cubes.end(), [&](const RigidState& cube) {
      const Vec3 within = cube.world_from_body().inverse() * point;
      return within.cwiseAbs().maxCoeff() <= half_cube;
    });
  }
  return static_cast<double>(solid) / static_cast<double>(kPoints);
}

// Random packings of cubes fill 0.54 (loose) to 0.67 (vibrated) of their space [baker2010]. Dice do
// not resist rolling.
TEST_F(SettledMass, FillsItsSpaceAsRandomPackingsDo) {
  std::string cubes =
      replaced_once(with_mass("[[mass]]\npolygon = [[3, -2], [7, -2], [7, 2], [3, 2]]\n"
                              "settle = true\n",
                              60),
                    "draw", "select = [\"cube\"]\ndraw");
  cubes = replaced_once(cubes, "rolling_friction = 0.2", "rolling_friction = 0");
  const CampaignPlan plan = prepared(cubes);
  const CampaignResults results = run(cubes, "cubes.h5");
  std::vector<RigidState> packed, settled;
  for (const RunRecord& record : results.runs) {
    ASSERT_EQ(record.result.stop_reason, StopReason::kRest) << record.result.message;
    for (const bool at_rest : {false, true}) {
      RigidState state = at_rest ? record.start : plan.runs[record.run].start;
      state.position = results.frame.to_map(state.position);
      (at_rest ? settled : packed).push_back(state);
    }
  }
  const double half = 0.35;  // of a cube, with its radius
  const Vec2 low(3.2, -1.8), high(6.8, 1.8);
  const double before = solid_inside(packed, half, low, high);
  const double after = solid_inside(settled, half, low, high);
  EXPECT_GT(after, before + 0.1) << before;
  EXPECT_GT(after, 0.54);
  EXPECT_LT(after, 0.67);
  // The report measures all of the heap from its tops, rough as they are.
  const Comparison comparison = compare({results});
  const DepositMeasures deposit = measure_deposits(comparison).realisations.at(0);
  EXPECT_NEAR(deposit.start_volume / deposit.start_bulk_volume, after, 0.06);
}

TEST_F(SettledMass, IsKeptAsAFailureWhereItDoesNotSettle) {
  const CampaignResults results = run(text("settle = true\nsettle_time_s = 0.1\n"), "moving.h5");
  for (const RunRecord& record : results.runs) {
    EXPECT_EQ(record.result.stop_reason, StopReason::kError);
    EXPECT_TRUE(contains(record.result.message, "still moved after settle_time_s = 0.1; raise it"));
  }
}

TEST_F(SettledMass, ATrialThatDoesNotSettleIsReported) {
  const CampaignPlan plan = prepared(text("settle = true\nsettle_time_s = 0.1\n"));
  EXPECT_TRUE(
      contains(measure_run_time(plan, 2.0).first_failure, "still moved after settle_time_s = 0.1"));
}

TEST_F(SettledMass, ATrialIsCutShortWhileItSettles) {
  const RunTimeProbe probe = measure_run_time(prepared(text("settle = true\n")), 0.0);
  EXPECT_TRUE(probe.last_run_stopped);
  EXPECT_TRUE(probe.is_upper_bound);
  EXPECT_EQ(probe.runouts.size(), 0u);
}

TEST_F(SettledMass, RefusesWhatDoesNotFit) {
  const auto refused = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(contains(clast::refusal<Error>([&] { prepared(text); }), part));
  };
  refused(text("faces = \"together\"\n"), "applies to a heap that settles; add settle = true");
  refused(text("settle = true\nfaces = \"apart\"\n"), "\"together\"");
  refused(text("settle = true\nfaces = \"one by one\"\n"), "face_interval_s is missing");
  refused(text("settle = true\nface_interval_s = 1\n"), "applies to faces = \"one by one\"");
  refused(text("settle = true\nsettle_time_s = 0\n"), "settle_time_s = 0");
  refused(replaced_once(text(), "[-4, 1], [-6, 1]]", "[-4, 1], [-5, 0], [-6, 1]]"),
          "is not convex at its corner 4, [-5, 0]");
  refused(replaced_once(text(), "[-4, -1], [-4, 1], [-6, 1]]", "[-4, 1], [-4, -1], [-6, 2]]"),
          "its sides 1 and 3 meet at");
  refused(replaced_once(text("in_place = true\nsettle = true\n"),
                        "polygon = [[-6, -1], [-4, -1], [-4, 1], [-6, 1]]\n", ""),
          "applies to a heap; blocks in place");
}

TEST(ReflexCorner, IsFoundInEitherSense) {
  std::vector<Vec2> polygon = {{0, 0}, {4, 0}, {4, 2}, {2, 1}, {0, 2}};
  EXPECT_EQ(find_reflex_vertex(polygon), 3u);
  std::reverse(polygon.begin(), polygon.end());
  EXPECT_EQ(find_reflex_vertex(polygon), 1u);
  // A corner on a side, and the first corner again.
  EXPECT_FALSE(
      find_reflex_vertex(std::vector<Vec2>{{0, 0}, {2, 0}, {4, 0}, {4, 2}, {0, 2}, {0, 0}}));
  // A pentagram turns twice.
  std::vector<Vec2> star;
  for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(0.8 * kPi * i), std::sin(0.8 * kPi * i));
  EXPECT_TRUE(find_reflex_vertex(star));
}

}  // namespace
}  // namespace clast
