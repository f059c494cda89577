// A run does what it does alone: nothing it is made from depends on which other blocks, releases
// and members of an ensemble its campaign has.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/number_text.hpp"
#include "study/results/results_journal.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {

using namespace study_detail;
namespace {

const std::string kCompanyPoints = "points = [[-12, -3, 9.5], [-12, 3, 9.5]]";

/// Everything that is stored of the runs of one block, each as bytes, by release set, point,
/// orientation and ground set. Numbers that count over the campaign are left out.
using Runs = std::map<std::string, std::string>;

class Company : public CampaignRun {
 protected:
  /// A pebble of 0.2 m and a heavy block of 2 m between the two of CampaignRun.
  static void SetUpTestSuite() {
    CampaignRun::SetUpTestSuite();
    BlockLibrary library;
    for (const auto& [id, size] :
         {std::pair{"pebble", Vec3(0.22, 0.2, 0.18)}, std::pair{"slab", Vec3(1.0, 0.6, 0.3)},
          std::pair{"heavy", Vec3(2.4, 2.0, 1.6)}, std::pair{"cube", Vec3(0.6, 0.6, 0.6)}}) {
      const TriangleMesh mesh = centred_box_mesh(size);
      BlockSource source;
      source.file = "box.stl";
      source.sha256 = std::string(64, '0');
      BlockOptions options;
      options.core = true;
      options.radius = 0.02;
      library.add(make_block(id, mesh, mesh, source, options));
    }
    library.write(*folder_ / "blocks.h5");
  }

  /// Short, with a barrier on the slope that is passed soon.
  static std::string campaign_text() {
    std::string text =
        replaced_once(CampaignRun::campaign_text(), "max_time_s = 6", "max_time_s = 3");
    return replaced_once(text, "from = [0, -20]\nto = [0, 20]",
                         "from = [-11, -20]\nto = [-11, 20]");
  }
  static std::string with(const std::string& from, const std::string& to) {
    return replaced_once(campaign_text(), from, to);
  }

  /// The campaign with these blocks, and what else is replaced.
  static std::string of(const std::string& blocks, std::string text = campaign_text()) {
    return replaced_once(std::move(text), "[terrain]", "select = [" + blocks + "]\n[terrain]");
  }

  static Runs stored(const std::filesystem::path& file, const std::string& block) {
    const CampaignResults results = read_results(file);
    Runs runs;
    std::size_t crossings = 0, impacts = 0;
    for (const RunRecord& record : results.runs) {
      if (results.blocks[record.block].id != block) continue;
      StoredRun run;
      run.record = record;
      for (const Crossing& crossing : results.crossings) {
        if (crossing.run == record.run) run.crossings.push_back(crossing);
      }
      for (const Impact& impact : results.impacts) {
        if (impact.run == record.run) run.impacts.push_back(impact);
      }
      run.trajectory = read_trajectory(file, record.run);
      crossings += run.crossings.size();
      impacts += run.impacts.size();
      const Vec3 start = results.frame.to_map(record.start.position);
      const std::string name = format_significant(start.y(), 6) + " " +
                               format_significant(start.z(), 6) + " " +
                               std::to_string(record.orientation) + " " +
                               std::to_string(results.ground_sets[record.ground_set].member);
      run.record.run = run.record.block = run.record.point = run.record.ground_set = 0;
      for (Crossing& crossing : run.crossings) crossing.run = 0;
      for (Impact& impact : run.impacts) impact.run = 0;
      EXPECT_TRUE(runs.emplace(name, serialize_stored_run(run)).second) << name << " comes twice";
    }
    EXPECT_TRUE(crossings > 0 && impacts > 0) << "nothing to compare";
    return runs;
  }

  /// Does a campaign and returns the runs of a block.
  static Runs run_count(const std::string& block, const std::string& text,
                        const CampaignRunOptions& options = {.threads = 1, .replace = true}) {
    run_campaign(prepared(text), *folder_ / "company.h5", options);
    return stored(*folder_ / "company.h5", block);
  }

  /// That `some` come as they are among `all`.
  static void expect_among(const Runs& some, const Runs& all) {
    for (const auto& [name, bytes] : some) {
      const auto same = all.find(name);
      ASSERT_NE(same, all.end()) << name;
      EXPECT_TRUE(same->second == bytes) << "run " << name << " differs";
    }
  }
  static void expect_same(const Runs& some, const Runs& all) {
    EXPECT_EQ(some.size(), all.size());
    expect_among(some, all);
  }
};

TEST_F(Company, OtherBlocksChangeNothing) {
  const Runs alone = run_count("slab", of("\"slab\""));
  ASSERT_EQ(alone.size(), 6u);
  expect_same(alone, run_count("slab", campaign_text()));
  expect_same(alone, run_count("slab", of("\"slab\", \"pebble\"")));
  expect_same(alone, run_count("slab", of("\"heavy\", \"slab\"")));
  expect_same(alone, run_count("slab", of("\"heavy\", \"pebble\", \"cube\", \"slab\"")));
  // Neither do they where blocks are brought to one mass.
  const auto of_mass = [](const std::string& blocks) {
    return replaced_once(of(blocks), "[terrain]", "scale = { mass_kg = 500 }\n[terrain]");
  };
  const Runs scaled = run_count("slab", of_mass("\"slab\""));
  expect_same(scaled, run_count("slab", of_mass("\"pebble\", \"slab\", \"heavy\"")));
  EXPECT_TRUE(scaled != alone);
}

TEST_F(Company, NeitherDoThreadsNorShards) {
  const Runs alone = run_count("slab", of("\"slab\""));
  expect_same(alone, run_count("slab", campaign_text(), {.threads = 2, .replace = true}));
  run_in_shards(prepared(campaign_text()), 3);
  expect_same(alone, stored(*folder_ / "merged.h5", "slab"));
}

// Each member runs as a campaign of its own with the parameters that were drawn for it, and those
// do not depend on other blocks either, not even on groups with uncertain ground of their own.
TEST_F(Company, OtherMembersOfAnEnsembleChangeNothing) {
  const std::string uncertain =
      with("energy_restitution = 0.1", "energy_restitution = { uniform = [0.01, 0.3] }") +
      "[ensemble]\nmembers = 3\nseed = 9\n";
  const std::string schist =
      "[[block_group]]\nname = \"schist\"\nselect = [\"heavy\"]\n"
      "ground.slope = { friction = { uniform = [0.2, 0.4] } }\n";
  const Runs alone = run_count("slab", of("\"slab\"", uncertain));
  ASSERT_EQ(alone.size(), 18u);
  expect_same(alone, run_count("slab", of("\"pebble\", \"slab\", \"heavy\"", uncertain)));
  expect_same(alone, run_count("slab", of("\"heavy\", \"slab\"", uncertain + schist)));
  const CampaignPlan plan = prepared(of("\"slab\"", uncertain));
  std::set<double> drawn;
  for (const GroundParameterSet& set : plan.header.ground_sets) {
    const double restitution = set.zones[0].energy_restitution;
    drawn.insert(restitution);
    const Runs own = run_count(
        "slab",
        of("\"slab\"", with("energy_restitution = 0.1",
                            "energy_restitution = " + format_significant(restitution, 17))));
    for (const auto& [name, bytes] : own) {
      std::string of_member = name;
      of_member.back() = static_cast<char>('0' + set.member);
      ASSERT_TRUE(alone.contains(of_member)) << of_member;
      EXPECT_TRUE(alone.at(of_member) == bytes) << "run " << of_member << " differs";
    }
  }
  EXPECT_EQ(drawn.size(), 3u);
}

TEST_F(Company, OtherReleasesChangeNothing) {
  // From the higher points blocks can be much faster, so that an impact decides on the stiffness.
  const Runs low = run_count("slab", of("\"slab\""));
  const std::string high =
      with(kCompanyPoints, "points = [[-12, -3, 9.5], [-12, 3, 9.5], [-19, 1, 60]]");
  const Runs both = run_count("slab", of("\"slab\"", high));
  EXPECT_EQ(both.size(), 9u);
  expect_among(low, both);
  // Also where the height of the centre follows from the orientation.
  const std::string dropped = with(kCompanyPoints, "points = [[-12, -3], [-12, 3]]\nheight_m = 1");
  const std::string one =
      replaced_once(dropped, "orientations = \"turns.txt\"", "orientations = \"first.txt\"");
  write_text_file(*folder_ / "first.txt", "1 0 0 0\n");
  expect_among(run_count("slab", of("\"slab\"", one)), run_count("slab", of("\"slab\"", dropped)));
}

TEST_F(Company, FreshOrientationsBelongToTheBlock) {
  const std::string fresh = with("\"turns.txt\"", "{ random = 2, seed = 5, fresh = true }");
  expect_same(run_count("slab", of("\"slab\"", fresh)), run_count("slab", fresh));
}

/// Of the first run of each block, by id.
std::map<std::string, RunRecord> first_runs(const CampaignPlan& plan) {
  std::map<std::string, RunRecord> runs;
  for (const RunRecord& run : plan.runs) runs.emplace(plan.header.blocks[run.block].id, run);
  return runs;
}

// m g/(e_n^2 d) with d = min(2 cm, 2 % of S), m v^2/(S/4)^2 if that is more, k_r = k_t (S/2)^2.
TEST_F(Company, EveryBlockHasTheStiffnessOfItsOwnMassAndSize) {
  const CampaignPlan plan = prepared();
  const auto runs = first_runs(plan);
  ASSERT_EQ(runs.size(), 4u);
  bool by_rest = false, by_impact = false;
  for (const auto& [id, run] : runs) {
    const RigidBody body = plan.bodies[run.block];
    const double side = body.smallest_side, depth = std::min(0.02, 0.02 * side);
    const double rest = body.mass * 9.81 / (0.1 * depth);
    // From 9.5 m on the map to the flat at 0 m.
    const double impact = body.mass * 2 * 9.81 * 9.5 / (0.0625 * side * side);
    (rest > impact ? by_rest : by_impact) = true;
    const double normal = std::max(rest, impact);
    EXPECT_NEAR(run.stiffness.normal, normal, 1e-9 * normal) << id;
    EXPECT_EQ(run.stiffness.tangential, run.stiffness.normal) << id;
    EXPECT_NEAR(run.stiffness.rolling, normal * 0.25 * side * side, 1e-9 * normal) << id;
    EXPECT_NEAR(run.settled_depth, body.mass * 9.81 / (0.1 * normal), 1e-12) << id;
    // m v^2/2 + m g h = k h^2/2
    const double h = run.impact_depth;
    EXPECT_NEAR(body.mass * 9.81 * (9.5 + h), 0.5 * normal * h * h, 1e-6 * normal * h * h) << id;
  }
  EXPECT_TRUE(by_rest && by_impact) << "both rules must decide once";
  EXPECT_LT(runs.at("pebble").stiffness.time_step, runs.at("heavy").stiffness.time_step);
}

TEST_F(Company, WhatTheUserGivesIsForAllBlocks) {
  const auto given = [](const std::string& keys) {
    return with("[terrain]", "[contact]\n" + keys + "\n[terrain]");
  };
  for (const auto& [id, run] : first_runs(prepared(given("stiffness_n_m = 1e8")))) {
    EXPECT_EQ(run.stiffness.normal, 1e8) << id;
    EXPECT_EQ(run.stiffness.tangential, 1e8) << id;
  }
  for (const auto& [id, run] :
       first_runs(prepared(given("stiffness_n_m = 1e8\ntangential_stiffness_n_m = 5e7\n"
                                 "rolling_stiffness_n_m_rad = 3e6\ntime_step_s = 1e-5")))) {
    EXPECT_EQ(run.stiffness.normal, 1e8) << id;
    EXPECT_EQ(run.stiffness.tangential, 5e7) << id;
    EXPECT_EQ(run.stiffness.rolling, 3e6) << id;
    EXPECT_EQ(run.stiffness.time_step, 1e-5) << id;
  }
}

TEST_F(Company, WarningsNameTheBlock) {
  const auto given = [](const std::string& keys) {
    return with("[terrain]", "[contact]\n" + keys + "\n[terrain]");
  };
  // The heavy block's own is 1e8 N/m, of all others less than 2e7.
  const CampaignPlan plan = prepared(given("stiffness_n_m = 5e7"));
  std::vector<std::string> soft;
  for (const std::string& warning : plan.header.warnings) {
    if (contains(warning, "softer than")) soft.push_back(warning);
  }
  ASSERT_EQ(soft.size(), 1u);
  EXPECT_TRUE(contains(soft[0], "block heavy: k_n = 5e+07 N/m is softer than the ")) << soft[0];
  // Too long for the pebble only.
  const std::string too_long = given("stiffness_n_m = 1e8\ntime_step_s = 7e-4");
  const std::string message = refusal(too_long);
  EXPECT_TRUE(contains(message, "block pebble: time step 0.0007 s is too long")) << message;
  EXPECT_EQ(refusal(replaced_once(too_long, "[contact]", "select = [\"heavy\"]\n[contact]")), "");
}

}  // namespace
}  // namespace clast
