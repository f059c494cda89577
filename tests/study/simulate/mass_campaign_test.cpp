// Campaigns that release a rock mass at once.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "library/rock_mass_blocks.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "study/simulate/memory_need.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {
namespace {

class MassCampaign : public CampaignRun {
 protected:
  /// Two realisations of eight blocks in a heap at the foot of the slope.
  static std::string text(const std::string& mass = kMass) {
    std::string text = campaign_text();
    const std::size_t begin = text.find("[release]");
    text.replace(begin, text.find("[[barrier]]") - begin, mass);
    text = replaced_once(text, "[terrain]", "draw = { count = 8 }\n[terrain]");
    return replaced_once(text, "max_time_s = 6", "max_time_s = 20") +
           "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.2\n";
  }
  static CampaignResults run(const std::string& file, const CampaignRunOptions& options = {}) {
    run_campaign(prepared(text()), *folder_ / file, options);
    return read_results(*folder_ / file);
  }
  static constexpr const char* kMass =
      "[[mass]]\npolygon = [[-4, -1.5], [-1, -1.5], [-1, 1.5], [-4, 1.5]]\nrealisations = 2\n";
};

TEST_F(MassCampaign, DrawsAsManyBlocksAsHaveAVolume) {
  const std::string of_volume = "draw = { volume_m3 = 0.5, mass_kg = { uniform = [20, 60] } }";
  const CampaignPlan plan = prepared(replaced_once(text(), "draw = { count = 8 }", of_volume));
  ASSERT_EQ(plan.masses.size(), 2u);
  EXPECT_NE(plan.masses[0].volume, plan.masses[1].volume);
  const double density = plan.bodies[0].mass / plan.header.blocks[0].volume;
  for (const MultiBlockStart& mass : plan.masses) {
    EXPECT_EQ(mass.blocks, std::lround(0.5 * density / 40.0));
    EXPECT_NEAR(mass.volume, 0.5, 0.1);
  }
  const std::string too_small = replaced_once(of_volume, "0.5", "0.005");
  EXPECT_TRUE(contains(refusal(replaced_once(text(), "draw = { count = 8 }", too_small)),
                       "[blocks] draw volume_m3 = 0.005 comes to 0.3"));
}

TEST_F(MassCampaign, IsRefusedWhereTheMachineHasTooLittleMemory) {
  const CampaignPlan plan = prepared(text());
  const double each = estimate_realisation_memory(plan);
  EXPECT_GT(each, 8 * 40e3);  // of eight small blocks, and a state of each every 0.1 s
  EXPECT_LT(each, 8 * 100e3);
  EXPECT_NO_THROW(check_free_memory(plan, 2, 2.1 * each));
  EXPECT_NO_THROW(check_free_memory(plan, 2, std::nullopt));
  const auto message = [&](double available) {
    return clast::refusal<InputError>([&] { check_free_memory(plan, 2, available); });
  };
  EXPECT_TRUE(contains(message(1.5 * each), "campaign.toml: 2 realisations of 8 blocks at a time"));
  EXPECT_TRUE(contains(message(1.5 * each), "is free; use fewer threads"));
  EXPECT_TRUE(contains(message(0.5 * each), "is free; use fewer blocks"));
  const std::string states =
      replaced_once(text(), "max_time_s = 20", "max_time_s = 20\ntrajectory_interval_s = 0.01");
  EXPECT_NEAR(estimate_realisation_memory(prepared(states)) - each, 8 * (2000 - 200) * 112.0, 1.0);
  // Blocks that run one by one take next to nothing.
  EXPECT_EQ(estimate_realisation_memory(prepared()), 0.0);
}

TEST_F(MassCampaign, ReleasesAllBlocksOfAHeapAtOnce) {
  const CampaignPlan plan = prepared(text());
  ASSERT_EQ(plan.masses.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    double volume = 0.0;
    for (std::size_t run = 8 * i; run < 8 * (i + 1); ++run) {
      volume += plan.header.blocks[plan.runs[run].block].volume;
    }
    EXPECT_NEAR(plan.masses[i].volume, volume, 1e-12);
    EXPECT_NEAR(plan.masses[i].area, 9.0, 0.5);
    EXPECT_GT(plan.masses[i].solid_fraction(), 0.2);
    EXPECT_LT(plan.masses[i].solid_fraction(), 0.7);
  }
  const CampaignResults results = run("mass.h5");
  ASSERT_EQ(results.runs.size(), 16u);
  EXPECT_TRUE(results.persistent_blocks->at_once);
  EXPECT_EQ(results.release_points.size(), 1u);
  std::set<double> places;
  for (std::size_t i = 0; i < 16; ++i) {
    const RunRecord& record = results.runs[i];
    EXPECT_EQ(results.persistent_block_records[i].released_at, 0.0);
    EXPECT_EQ(results.persistent_block_records[i].raise_height, 0.0);
    expect_equal(record.start, plan.runs[i].start);
    EXPECT_EQ(record.result.stop_reason, StopReason::kRest);
    EXPECT_LT(record.result.energy.error, 1e-3);
    EXPECT_EQ(record.result.duration, results.runs[i / 8 * 8].result.duration);
    places.insert(record.start.position.x() + 10.0 * record.start.position.y());
  }
  EXPECT_EQ(places.size(), 16u);  // not twice the same heap
  // Until they rest, energies are sampled at the interval of states, and balance.
  const EnergySample& start = results.energies.front().energy;
  EXPECT_EQ(start.time, 0.0);
  EXPECT_EQ(start.moving, 8u);
  EXPECT_EQ(results.energies.front().run, 0u);
  EXPECT_EQ(results.energies.back().run, 8u);
  EXPECT_EQ(results.energies.back().energy.moving, 0u);
  for (const EnergyRecord& record : results.energies) {
    if (record.run > 0) break;
    const double dropped = start.potential - record.energy.potential;
    EXPECT_NEAR(record.energy.sum(), start.sum(), 1e-3 * dropped + 1e-9);
    EXPECT_LE(record.energy.time, results.runs[0].result.duration);
  }
  std::vector<CampaignResults> all = {results};
  const Comparison comparison = compare(std::move(all));
  const DepositResults deposits = measure_deposits(comparison);
  ASSERT_EQ(deposits.realisations.size(), 2u);
  for (const DepositMeasures& deposit : deposits.realisations) {
    EXPECT_EQ(deposit.deposited_blocks, 8u);
    EXPECT_NEAR(deposit.volume, plan.masses[deposit.realisation].volume, 1e-9);
    EXPECT_GT(deposit.bulk_volume, 0.8 * deposit.volume);
    EXPECT_GT(deposit.centre.x(), deposit.start_centre.x());
    EXPECT_LT(deposit.centre.z(), deposit.start_centre.z());
  }
}

TEST_F(MassCampaign, RecordsTheImpactsOfEachBlock) {
  const CampaignResults results = run("impacts.h5");
  std::vector<std::size_t> impacts(results.runs.size(), 0);
  for (const Impact& impact : results.impacts) {
    ++impacts[impact.run];
    EXPECT_GT(impact.depth, 0.0);
    EXPECT_GT(impact.speed_before, 0.0);
    EXPECT_LE(impact.time + impact.contact_duration, results.runs[impact.run].result.duration);
  }
  double flown = 0.0;
  for (const RunRecord& run : results.runs) {
    EXPECT_GE(impacts[run.run], 1u) << run.run;
    EXPECT_LE(impacts[run.run], run.result.impacts);
    EXPECT_GT(run.contacts.contact_time, 0.0);
    EXPECT_LT(run.contacts.contact_time, run.result.duration);
    EXPECT_GE(run.contacts.mean_contact_points, 1.0);
    flown = std::max(flown, run.contacts.longest_flight);
  }
  EXPECT_GT(flown, 0.0);
}

TEST_F(MassCampaign, WithoutTrajectoriesEnergiesAreOfEachSecond) {
  const std::string of = replaced_once(text(), "[run]\n", "[run]\ntrajectory_interval_s = 0\n");
  run_campaign(prepared(of), *folder_ / "seconds.h5");
  std::vector<double> times;
  for (const EnergyRecord& record : read_results(*folder_ / "seconds.h5").energies) {
    if (record.run == 0) times.push_back(record.energy.time);
  }
  ASSERT_GT(times.size(), 3u);
  EXPECT_EQ(times.front(), 0.0);
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    EXPECT_GE(times[i], static_cast<double>(i));
    EXPECT_LT(times[i], static_cast<double>(i) + 0.1);
  }
}

TEST_F(MassCampaign, IsTheSameOnThreadsAndInShards) {
  const CampaignResults whole = run("whole.h5", {.threads = 1});
  const CampaignResults threads = run("threads.h5", {.threads = 2});
  const CampaignPlan plan = prepared(text());
  const CampaignResults merged = run_in_shards(plan, 2);
  EXPECT_TRUE(merged.persistent_blocks->at_once);
  ASSERT_EQ(merged.runs.size(), whole.runs.size());
  ASSERT_GT(whole.energies.size(), 20u);
  expect_equal_energies(threads, whole);
  expect_equal_energies(merged, whole);
  for (std::size_t i = 0; i < whole.runs.size(); ++i) {
    expect_equal(whole.runs[i].result.final_state, threads.runs[i].result.final_state);
    expect_equal(whole.runs[i].result.final_state, merged.runs[i].result.final_state);
  }
}

TEST_F(MassCampaign, MoreRealisationsLeaveTheFirstOnesAsTheyAre) {
  const CampaignPlan few = prepared(text());
  const CampaignPlan more = prepared(replaced_once(text(), "realisations = 2", "realisations = 3"));
  ASSERT_EQ(more.runs.size(), 24u);
  for (std::size_t i = 0; i < few.runs.size(); ++i) {
    expect_equal(few.runs[i].start, more.runs[i].start);
  }
  const CampaignPlan other =
      prepared(replaced_once(text(), "realisations = 2", "realisations = 2\nseed = 7"));
  EXPECT_NE(other.runs[0].start.position, few.runs[0].start.position);
}

// Blocks that joints cut from a mass on the slope, released from where they were cut.
TEST_F(MassCampaign, ReleasesBlocksInPlace) {
  TriangleMesh mass = centred_box_mesh({2.0, 2.0, 1.5});
  const double dip = std::atan(0.6);
  mass = transformed(mass, Pose{Vec3(-3.0, 0.0, 1.8) + 0.8 * Vec3(std::sin(dip), 0, std::cos(dip)),
                                Quat(Eigen::AngleAxisd(dip, Vec3::UnitY()))});
  RockMassOptions options;
  for (const char* set : {"59/270/1", "90/0/0.9", "31/90/0.8"}) {
    options.joints.push_back(parse_joint_set(set));
  }
  const RockMassBlocks made =
      cut_rock_mass(mass, {"mass.ply", std::string(64, '0'), "", ""}, options);
  BlockLibrary library;
  for (const Block& block : made.blocks) library.add(block);
  library.write(*folder_ / "insitu.h5");
  std::string in_place = text("[mass]\nin_place = true\n");
  in_place = replaced_once(in_place, "draw = { count = 8 }\n", "");
  in_place = replaced_once(in_place, "\"blocks.h5\"", "\"insitu.h5\"");
  const CampaignPlan plan = prepared(in_place);
  ASSERT_EQ(plan.runs.size(), made.blocks.size());
  EXPECT_NEAR(plan.masses[0].volume, made.block_volume, 1e-9);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const Vec3 place = plan.header.frame.to_map(plan.runs[i].start.position);
    EXPECT_LT((place - made.blocks[i].mass.centre).norm(), 1e-9);
  }
  run_campaign(plan, *folder_ / "placed.h5");
  for (const RunRecord& run : read_results(*folder_ / "placed.h5").runs) {
    EXPECT_EQ(run.result.stop_reason, StopReason::kRest) << run.result.message;
    EXPECT_LT(run.result.energy.error, 1e-3);
  }
  const auto refused = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(contains(clast::refusal<Error>([&] { prepared(text); }), part));
  };
  const auto also = [&](const std::string& line) {
    return replaced_once(in_place, "in_place = true\n", "in_place = true\n" + line);
  };
  EXPECT_EQ(prepared(also("height_m = 2.0\n")).runs[0].start.position,
            plan.runs[0].start.position + Vec3(0.0, 0.0, 2.0));
  refused(also("polygon = [[0, 0], [1, 0], [0, 1]]\n"), "applies to a heap");
  refused(also("face_interval_s = 2\n"), "face_interval_s = 2: applies to a heap");
  refused(replaced_once(in_place, "[terrain]", "scale = \"equal-mass\"\n[terrain]"),
          "neither drawn nor scaled");
  refused(text(std::string(kMass) + "height_m = 1\n"), "applies to blocks in place");
  // Those of the other library lie in one another.
  refused(replaced_once(in_place, "\"insitu.h5\"", "\"blocks.h5\""),
          "[mass] in_place: 1 pair of blocks overlap, the largest overlap is that of cube and "
          "slab, by 0.3 m");
  // A mass that reaches into the ground.
  for (Vec3& vertex : mass.vertices) vertex.z() -= 0.5;
  const RockMassBlocks deep =
      cut_rock_mass(mass, {"mass.ply", std::string(64, '0'), "", ""}, options);
  BlockLibrary other;
  for (const Block& block : deep.blocks) other.add(block);
  other.write(*folder_ / "deep.h5");
  refused(replaced_once(in_place, "\"insitu.h5\"", "\"deep.h5\""),
          "m inside the ground; the terrain must be the one without the mass");
}

TEST_F(MassCampaign, RefusesWhatDoesNotFit) {
  const auto refused = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(contains(clast::refusal<Error>([&] { prepared(text); }), part));
  };
  const auto mass = [](const std::string& from, const std::string& to) {
    return replaced_once(text(), from, to);
  };
  refused(mass("polygon = [[-4, -1.5], [-1, -1.5], [-1, 1.5], [-4, 1.5]]\n", ""),
          "polygon is missing");
  refused(mass("[-1, -1.5], [-1, 1.5], [-4, 1.5]]", "[-1, -1.5]]"), "at least 3 points");
  refused(mass("[-1, -1.5], [-1, 1.5], [-4, 1.5]]", "[-3, -1.5], [-2, -1.5]]"), "has no area");
  refused(mass("[-4, 1.5]", "[-40, 1.5]"), "reaches beyond the terrain");
  refused(mass("realisations = 2", "realisations = 0"), "must be from 1");
  refused(mass("realisations = 2", "realisations = 2\nthickness = 2"), "unknown key");
  refused(mass("realisations = 2", "thickness_m = -1"), "thickness_m = -1");
  refused(mass("realisations = 2", "thickness_m = 0.9"),
          "below thickness_m = 0.9; raise it, widen the polygon");
  refused(mass("[-1, -1.5], [-1, 1.5], [-4, 1.5]", "[-3.7, -1.5], [-3.7, -1.2], [-4, -1.2]"),
          "[mass] holds 0 of 8 blocks of realisation 1, and block ");
  refused(text(std::string(kMass) + "share = 0.5\n"),
          "makes the sum of the fractions of all masses 0.5; it must be 1");
  refused(text(std::string(kMass) + "count = 5\n"), "make 5 of 8 blocks of a realisation");
  refused(text(std::string(kMass) + "release_time_s = 2\n"), "no mass is released at time 0");
  refused(text() + "[release]\npoints = [[0, 0, 1]]\n", "leave out [release], or [mass]");
  const std::string without = text();
  refused(without.substr(0, without.find("[contact.blocks]")),
          "the blocks of a mass hit each other; add [contact.blocks]");
  refused(text() +
              "[[block_group]]\nname = \"g\"\nselect = [\"cube\"]\nground.flat = { friction "
              "= 0.5 }\n",
          "leave the block groups out");
}

}  // namespace
}  // namespace clast
