// Campaigns that release several rock masses.
#include <gtest/gtest.h>

#include <set>

#include "study/compare/barrier_statistics.hpp"
#include "study/compare/run_columns.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {
namespace {

class SeveralMasses : public CampaignRun {
 protected:
  /// Two realisations of nine blocks in two heaps above each other on the slope.
  /// @param masses  the tables [[mass]]
  static std::string text(const std::string& masses) {
    std::string text = campaign_text();
    const std::size_t begin = text.find("[release]");
    text.replace(begin, text.find("[[barrier]]") - begin, masses);
    text = replaced_once(text, "[terrain]", "draw = { count = 9 }\n[terrain]");
    return replaced_once(text, "max_time_s = 6", "max_time_s = 20") +
           "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.2\n";
  }
  /// @param of_lower  more keys of the mass below
  static std::string masses(const std::string& of_lower = "", const std::string& of_upper = "") {
    return "[[mass]]\nname = \"upper\"\nrealisations = 2\n"
           "polygon = [[-9, -1.5], [-5, -1.5], [-5, 1.5], [-9, 1.5]]\n" +
           of_upper +
           "[[mass]]\nname = \"lower\"\n"
           "polygon = [[-5, -1.5], [-3, -1.5], [-3, 1.5], [-5, 1.5]]\n" +
           of_lower;
  }
  static CampaignResults run(const std::string& text, const std::string& file,
                             const CampaignRunOptions& options = {}) {
    run_campaign(prepared(text), *folder_ / file, options);
    return read_results(*folder_ / file);
  }
  static std::vector<std::size_t> counts(const std::string& of_lower, const std::string& of_upper) {
    const CampaignPlan plan = prepared(text(masses(of_lower, of_upper)));
    std::vector<std::size_t> counts;
    for (std::size_t i = 0; i < 2; ++i) counts.push_back(plan.masses[i].blocks);
    return counts;
  }
};

TEST_F(SeveralMasses, HaveTheirShareOfTheBlocks) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(counts("", ""), Counts({6, 3}));               // as 12 m^2 to 6 m^2
  EXPECT_EQ(counts("share = 0.5\n", ""), Counts({5, 4}));  // of two halves the first
  EXPECT_EQ(counts("share = 0.25\n", "share = 0.75\n"), Counts({7, 2}));
  EXPECT_EQ(counts("count = 1\n", ""), Counts({8, 1}));
  EXPECT_EQ(counts("count = 4\n", "count = 5\n"), Counts({5, 4}));
  EXPECT_EQ(counts("count = 3\n", "share = 0.666666667\n"), Counts({6, 3}));
}

TEST_F(SeveralMasses, StartInTheirPolygons) {
  const CampaignPlan plan = prepared(text(masses("release_time_s = 4\n")));
  ASSERT_EQ(plan.masses.size(), 4u);
  EXPECT_EQ(plan.header.release_sets, (std::vector<std::string>{"upper", "lower"}));
  EXPECT_EQ(plan.header.set_of_point, (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(plan.runs.size(), 18u);
  double volume = 0.0;
  std::set<std::uint32_t> blocks;
  for (const RunRecord& run : plan.runs) {
    EXPECT_EQ(run.point, run.run % 9 < 6 ? 0u : 1u);
    blocks.insert(run.block);
    const double x = plan.header.frame.to_map(run.start.position).x();
    EXPECT_GT(x, run.point == 0 ? -9.0 : -5.0);
    EXPECT_LT(x, run.point == 0 ? -5.0 : -3.0);
    volume += plan.header.blocks[run.block].volume;
  }
  EXPECT_EQ(blocks.size(), 18u);  // each once
  double sum = 0.0;
  for (const MultiBlockStart& mass : plan.masses) sum += mass.volume;
  EXPECT_NEAR(sum, volume, 1e-12);
  EXPECT_NEAR(plan.masses[0].area, 12.0, 0.5);
  EXPECT_NEAR(plan.masses[1].area, 6.0, 0.5);
  EXPECT_EQ(plan.campaign.persistent_blocks->last_release_time(), 4.0);
}

/// The mass below is held while the one above falls on it, and let go later.
TEST_F(SeveralMasses, AreHeldUntilTheyAreReleased) {
  constexpr double kRelease = 12.0;
  const std::string held = text(masses("release_time_s = 12\n"));
  const CampaignResults results = run(held, "held.h5");
  const CampaignPlan plan = prepared(held);
  std::size_t hit = 0;
  for (const RunRecord& record : results.runs) {
    EXPECT_EQ(record.result.stop_reason, StopReason::kRest) << record.result.message;
    EXPECT_LT(record.result.energy.error, 1e-3);
    EXPECT_GT(record.result.duration, kRelease);
    expect_equal(record.start, plan.runs[record.run].start);
    const Trajectory path = read_trajectory(*folder_ / "held.h5", record.run);
    const bool lower = record.point == 1;
    const PersistentBlockRecord& stay = results.persistent_block_records[record.run];
    EXPECT_EQ(stay.released_at, lower ? kRelease : 0.0);
    if (!lower) hit += stay.blocks_hit;
    ASSERT_GT(path.time.size(), 2u);
    EXPECT_EQ(path.time[0], 0.0);
    if (!lower) continue;
    EXPECT_GE(path.time[1], kRelease - 1e-9);
    expect_equal(path.states[0], record.start);
    expect_equal(path.states[1], record.start);
    EXPECT_GT((path.states.back().position - record.start.position).norm(), 0.01);
  }
  EXPECT_GT(hit, 0u);
  // As long as the lower mass is held, the upper one can't pass it along the middle; then the
  // barrier at the foot is passed by blocks of the lower one, after its release alone.
  std::size_t crossings = 0;
  for (const Crossing& crossing : results.crossings) {
    if (results.runs[crossing.run].point != 1) continue;
    ++crossings;
    EXPECT_GT(crossing.time, kRelease);
  }
  EXPECT_GT(crossings, 0u);
  std::vector<CampaignResults> files = {results};
  const Comparison comparison = compare(std::move(files));
  for (const RealisationCrossings& passages : collect_barrier_crossings(comparison)) {
    for (const BlockCrossing& passage : passages.passages) {
      const RunRecord& record = *comparison.rows[passage.row].record;
      EXPECT_LT(passage.time, record.result.duration);
      if (record.point == 1) {
        EXPECT_GT(passage.time, kRelease);
      }
    }
  }
}

TEST_F(SeveralMasses, AreTheSameOnThreadsInShardsAndResumed) {
  const std::string held = text(masses("release_time_s = 2.5\n"));
  const CampaignResults whole = run(held, "whole.h5", {.threads = 1});
  const CampaignResults threads = run(held, "threads.h5", {.threads = 2});
  const CampaignPlan plan = prepared(held);
  const CampaignResults merged = run_in_shards(plan, 2);
  EXPECT_EQ(merged.release_sets, whole.release_sets);
  ASSERT_EQ(merged.runs.size(), whole.runs.size());
  for (std::size_t i = 0; i < whole.runs.size(); ++i) {
    expect_equal(whole.runs[i].result.final_state, threads.runs[i].result.final_state);
    expect_equal(whole.runs[i].result.final_state, merged.runs[i].result.final_state);
    EXPECT_EQ(whole.runs[i].point, merged.runs[i].point);
  }
}

TEST_F(SeveralMasses, AreGroupsOfAComparison) {
  std::vector<CampaignResults> files = {run(text(masses("release_time_s = 1\n")), "groups.h5")};
  Comparison comparison = compare(std::move(files));
  append_column_groups(comparison, "release_set");
  std::size_t upper = 0, lower = 0;
  for (const RunGroup& group : comparison.groups) {
    if (group.name == "release_set upper") upper = group.rows.size();
    if (group.name == "release_set lower") lower = group.rows.size();
  }
  EXPECT_EQ(upper, 12u);
  EXPECT_EQ(lower, 6u);
}

// Blocks in place belong to the mass whose polygon their centre lies in.
TEST_F(SeveralMasses, InPlaceDivideTheBlocksByTheirPolygons) {
  BlockLibrary library;
  for (int i = 0; i < 3; ++i) {
    const TriangleMesh mesh = transformed(centred_box_mesh({0.6, 0.6, 0.6}),
                                          Pose{Vec3(-9.0 + 2.0 * i, 0.0, 7.0), Quat::Identity()});
    BlockSource source;
    source.file = "box.stl";
    source.sha256 = std::string(64, '0');
    BlockOptions options;
    options.core = true;
    options.radius = 0.05;
    library.add(make_block("B" + std::to_string(i), mesh, mesh, source, options));
  }
  library.write(*folder_ / "placed.h5");
  const auto in_place = [&](const std::string& west, const std::string& east) {
    return replaced_once(
        replaced_once(
            text("[[mass]]\nname = \"west\"\nin_place = true\n" + west +
                 "[[mass]]\nname = \"east\"\nin_place = true\nrelease_time_s = 3\n" + east),
            "\"blocks.h5\"", "\"placed.h5\""),
        "draw = { count = 9 }\n", "");
  };
  const std::string west = "polygon = [[-8, -1], [-6, -1], [-6, 1], [-8, 1]]\n",
                    east = "polygon = [[-6, -1], [-4, -1], [-4, 1], [-6, 1]]\n",
                    wide = "polygon = [[-12, -1], [-6, -1], [-6, 1], [-12, 1]]\n",
                    all = "polygon = [[-12, -1], [0, -1], [0, 1], [-12, 1]]\n";
  const CampaignPlan plan = prepared(in_place(wide, east + "height_m = 1\n"));
  ASSERT_EQ(plan.masses.size(), 2u);
  EXPECT_EQ(plan.masses[0].blocks, 2u);
  EXPECT_EQ(plan.masses[1].blocks, 1u);
  EXPECT_NEAR(plan.header.frame.to_map(plan.runs[2].start.position).z(), 8.0, 1e-9);
  const CampaignResults results = run(in_place(wide, east), "in_place.h5");
  EXPECT_EQ(results.persistent_block_records[2].released_at, 3.0);
  const auto refused = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(contains(clast::refusal<Error>([&] { prepared(text); }), part));
  };
  refused(in_place(wide, ""), "polygon is missing");
  refused(in_place(west, east), "block B0 in place at x -9.000, y 0.000 lies in the polygon of no");
  refused(in_place(all, east), "lies in the polygon of [mass] west and of [mass] east");
  refused(in_place(all, "polygon = [[5, -1], [6, -1], [6, 1]]\n"),
          "[mass] east: no block in place");
  refused(in_place(wide, east + "share = 0.5\n"), "applies to a heap");
  refused(in_place(wide, east + "count = 1\n"), "applies to a heap");
}

TEST_F(SeveralMasses, RefuseWhatDoesNotFit) {
  const auto refused = [](const std::string& masses, const std::string& part) {
    EXPECT_TRUE(contains(clast::refusal<Error>([&] { prepared(text(masses)); }), part));
  };
  const std::string good = masses();
  refused(replaced_once(good, "name = \"lower\"\n", ""), "name is missing");
  refused(replaced_once(good, "\"lower\"", "\"upper\""), "another mass has this name");
  refused(replaced_once(good, "\"lower\"", "\" \""), "must not be blank");
  refused(masses("realisations = 2\n"), "give it only in the first [[mass]]");
  refused(masses("seed = 2\n"), "give it only in the first [[mass]]");
  refused(
      masses("release_time_s = 2\n", "release_time_s = 1\n"),
      "release_time_s = 1: times count from the first release, but no mass is released at time 0");
  refused(masses("release_time_s = -2\n"), "release_time_s = -2");
  refused(masses("share = 0.6\n", "share = 0.6\n"), "1.2; it must be 1");
  refused(masses("share = 1\n"), "some blocks must remain for the mass without a share");
  refused(masses("share = 0\n"), "share = 0");
  refused(masses("share = 0.5\ncount = 2\n"), "contradicts share");
  refused(masses("count = 9\n"),
          "make 9 of 9 blocks of a realisation and leave none for [mass] upper");
  refused(masses("count = 2\n", "count = 2\n"),
          "make 4 of 9 blocks of a realisation; change them to add up");
  refused(masses("share = 0.01\n"), "[mass] lower gets none of the 9 blocks");
  refused(masses("in_place = true\n"), "neither drawn nor scaled");
  refused(masses("thickness_m = 0.2\n"), "[mass] lower holds 0 of 3 blocks of realisation 1");
  refused(replaced_once(good, "[[-5, -1.5], [-3,", "[[-6, -1.5], [-3,"),
          "the polygons of [mass] upper and [mass] lower overlap on ");
  const std::string undrawn =
      replaced_once(text(masses("in_place = true\n")), "draw = { count = 9 }\n", "");
  EXPECT_TRUE(contains(clast::refusal<Error>([&] { prepared(undrawn); }),
                       "either all masses are in place or none"));
}

}  // namespace
}  // namespace clast
