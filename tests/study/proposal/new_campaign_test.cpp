// Campaigns proposed from a library and a terrain: that they are sensible, accepted, and run.
#include "study/proposal/new_campaign.hpp"

#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "study/results/results.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_fit.hpp"
#include "terrain/terrain_input.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/library/core_library.hpp"
#include "tests/study/facing_slope.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

Terrain terrain_of(const fs::path& file) {
  TerrainOptions options;
  options.surface = {file};
  return read_terrain(options);
}

Vec2 plan(const Vec3& point) { return point.head<2>(); }

void expect_sensible(const ProposedReleaseAndBarrier& places, const Terrain& terrain,
                     const FacingSlope& slope) {
  const double side = slope.cells * slope.cell;
  const std::vector<Vec3> ends = {places.releases.from, places.releases.to};
  EXPECT_NO_THROW(check_positions_over_terrain(terrain, ends, "releases"));
  for (const Vec3& release : ends) {
    EXPECT_GE(border_distance(terrain, plan(release)), places.margin);
    // In the upper half of the descent, on the slope and not on its foot.
    EXPECT_GT(release.z(),
              1800.0 + 0.5 * (terrain.frame.to_map(bounds(terrain.surface).high).z() - 1800.0));
    EXPECT_NEAR(release.z(), slope.height(plan(release)), 0.5);
  }
  EXPECT_NEAR(places.release_slope, slope.slope, 0.05);
  EXPECT_GT(places.downslope.dot(slope.downhill()), std::cos(15.0 * kRadiansPerDegree));

  const Vec2 along = plan(places.barrier.to) - plan(places.barrier.from);
  EXPECT_GT(along.norm(), 0.2 * places.distance);
  EXPECT_LT(std::abs(along.normalized().dot(places.downslope)), 0.02);
  const Vec2 centre = 0.5 * (plan(places.barrier.from) + plan(places.barrier.to));
  EXPECT_NEAR(slope.below_foot(centre), 0.0, 0.06 * side);
  // What comes down goes from the left of the line to its right.
  const Vec2 left(-along.y(), along.x());
  EXPECT_GT(left.dot(plan(places.releases.from) - centre), 0.0);
  EXPECT_GT(places.descent, 0.5 * places.distance);
}

class SlopesFacing : public testing::TestWithParam<int> {};

TEST_P(SlopesFacing, GetReleasesAboveAndABarrierAtTheFoot) {
  const ScratchFolder folder;
  const FacingSlope slope{.facing = GetParam() * kRadiansPerDegree};
  write_slope(folder / "slope.asc", slope);
  const Terrain terrain = terrain_of(folder / "slope.asc");
  const ProposedReleaseAndBarrier places =
      propose_release_and_barrier(terrain, make_terrain_surface(terrain), 1.0);
  EXPECT_EQ(places.release_points, 5u);
  expect_sensible(places, terrain, slope);
}

INSTANTIATE_TEST_SUITE_P(NewCampaign, SlopesFacing,
                         testing::Values(0, 37, 90, 135, 180, 200, 270, 341));

// A slope without a foot: the barrier lies before the ground ends.
TEST(NewCampaign, ASlopeWithoutAFootHasTheBarrierOnTheGround) {
  const ScratchFolder folder;
  const FacingSlope slope{.facing = 0.5, .slope = 33.0 * kRadiansPerDegree, .foot = 2.0};
  write_slope(folder / "slope.asc", slope);
  const Terrain terrain = terrain_of(folder / "slope.asc");
  const ProposedReleaseAndBarrier places =
      propose_release_and_barrier(terrain, make_terrain_surface(terrain), 0.8);
  const Vec3 centre = 0.5 * (places.barrier.from + places.barrier.to);
  EXPECT_NO_THROW(check_positions_over_terrain(terrain, std::vector<Vec3>{centre}, "barrier"));
  EXPECT_GT(places.distance, 40.0);
  EXPECT_NEAR(places.descent, std::tan(slope.slope) * places.distance, 3.0);
}

TEST(NewCampaign, MapCoordinatesChangeNothingElse) {
  const ScratchFolder folder;
  FacingSlope slope{.facing = 1.0};
  write_slope(folder / "far.asc", slope);
  const Vec2 offset = slope.corner;
  slope.corner = Vec2::Zero();
  write_slope(folder / "near.asc", slope);
  const auto places_on = [&](const std::string& name) {
    const Terrain terrain = terrain_of(folder / name);
    return propose_release_and_barrier(terrain, make_terrain_surface(terrain), 1.0);
  };
  const ProposedReleaseAndBarrier far = places_on("far.asc"), near = places_on("near.asc");
  EXPECT_LT((plan(far.releases.from) - plan(near.releases.from) - offset).norm(), 1e-3);
  EXPECT_LT((plan(far.barrier.to) - plan(near.barrier.to) - offset).norm(), 1e-3);
}

class NewCampaigns : public testing::Test {
 protected:
  void SetUp() override {
    write_core_library(folder / "blocks.h5", {{"cube", cuboid(0.8, 0.75, 0.7)},
                                              {"slab", cuboid(1.2, 0.9, 0.4)},
                                              {"bar", cuboid(1.6, 0.6, 0.5)}});
  }
  CampaignProposal write(const std::string& terrain, const std::string& library = "blocks.h5") {
    return write_new_campaign(folder / library, {folder / terrain}, folder / "campaign.toml",
                              {.replace = true});
  }
  std::string refusal_of(const std::string& terrain, const std::string& library = "blocks.h5") {
    const std::string text = refusal<Error>([&] { write(terrain, library); });
    EXPECT_FALSE(fs::exists(folder / "campaign.toml"));
    return text;
  }
  std::string text() const { return read_text_file(folder / "campaign.toml"); }
  /// Runs the written campaign with one orientation.
  CampaignResults run() {
    const std::string all = text();
    const std::size_t at = all.find("random = "), end = all.find(',', at);
    write_text_file(folder / "one.toml", all.substr(0, at) + "random = 1" + all.substr(end));
    run_campaign(prepare_campaign(read_campaign(folder / "one.toml")), folder / "results.h5",
                 {.replace = true});
    return read_results(folder / "results.h5");
  }
  static void expect_most_come_down(const CampaignResults& results) {
    std::size_t moved = 0;
    for (const RunRecord& run : results.runs) {
      const Vec3 way = run.result.final_state.position - run.start.position;
      moved += way.head<2>().norm() > 5.0 && way.z() < -3.0 ? 1 : 0;
      EXPECT_FALSE(run.result.below_ground);
    }
    EXPECT_GT(moved, results.runs.size() / 2);
  }

  ScratchFolder folder;
};

TEST_F(NewCampaigns, RunOnALargeSlope) {
  write_slope(folder / "slope.asc", {.cells = 400, .facing = 2.2});
  const CampaignProposal proposal = write("slope.asc");
  EXPECT_EQ(proposal.blocks.count, 3u);
  EXPECT_EQ(proposal.places.release_points, 5u);
  EXPECT_EQ(proposal.orientations, 16u);
  const CampaignPlan prepared = prepare_campaign(read_campaign(folder / "campaign.toml"));
  EXPECT_EQ(prepared.runs.size(), 3u * 5u * 16u);
  EXPECT_TRUE(prepared.header.warnings.empty()) << testing::PrintToString(prepared.header.warnings);
  EXPECT_TRUE(contains(text(), "library            = \"blocks.h5\"")) << text();
  EXPECT_GE(proposal.trial.passed, 4u);
  EXPECT_EQ(proposal.places.barrier_name, "foot");
  const CampaignResults results = run();
  expect_most_come_down(results);
  EXPECT_FALSE(results.crossings.empty());
  // Runs have the time they need, and rolling winds up over a length that is written down.
  EXPECT_GE(proposal.max_time, 2.0 * proposal.trial.longest);
  EXPECT_EQ(prepared.campaign.max_time, proposal.max_time);
  for (const RunRecord& record : results.runs) {
    EXPECT_NE(record.result.stop_reason, StopReason::kMaxTime) << record.run;
  }
  for (const GroundParameters& zone : results.ground) EXPECT_GT(zone.rolling_length, 0.0);
}

// Scree stops blocks on the benches: a barrier at the foot would count none.
TEST_F(NewCampaigns, SaySoWhereZonesNameNoGroundAndCountBlocksWhereTheyPass) {
  const fs::path samples = fs::path(CLAST_SOURCE_DIR) / "samples" / "terrain";
  TerrainOptions options;
  options.surface = {samples / "quarry_blue.ply", samples / "quarry_gray.ply",
                     samples / "quarry_red.ply"};
  options.zones = {"blue", "gray", "red"};
  write_terrain(folder / "quarry.h5", read_terrain(options));
  const CampaignProposal proposal = write("quarry.h5");
  ASSERT_EQ(proposal.ground.size(), 3u);
  for (const ProposedGround& zone : proposal.ground) {
    EXPECT_FALSE(zone.identified_by_name);
    EXPECT_EQ(zone.type.name, default_ground_type().name);
  }
  EXPECT_TRUE(contains(text(), "[ground.gray]") && contains(text(), "no ground type"));
  ASSERT_FALSE(proposal.proposal_warnings.empty());
  EXPECT_TRUE(contains(proposal.proposal_warnings[0], "3 ground zones are taken for scree"));
  EXPECT_TRUE(contains(text(), "NOTE: 3 ground zones"));
  EXPECT_EQ(proposal.trial.count, 16u);
  EXPECT_LT(proposal.trial.passed, 4u);
  ASSERT_EQ(proposal.places.barrier_name, "halfway");
  EXPECT_LE(proposal.places.distance, proposal.trial.median_distance);
  EXPECT_TRUE(contains(proposal.proposal_warnings.back(), "the foot of the slope"));
  EXPECT_TRUE(contains(text(), "name               = \"halfway\"")) << text();
  const CampaignResults results = run();
  expect_most_come_down(results);
  // About half of them, of which there are few here.
  EXPECT_GE(results.crossings.size(), results.runs.size() / 6);
  EXPECT_LE(results.crossings.size(), 5 * results.runs.size() / 6);
}

TEST_F(NewCampaigns, TakeGroundFromTheNamesOfZones) {
  write_slope(folder / "slope.asc", {});
  Terrain terrain = terrain_of(folder / "slope.asc");
  terrain.zone_names = {"upper cliff", "deep \"wet\" meadow", "éboulis", "a.b"};
  for (std::size_t i = 0; i < terrain.zone.size(); ++i) {
    terrain.zone[i] = static_cast<std::uint16_t>(4 * i / terrain.zone.size());
  }
  write_terrain(folder / "slope.h5", terrain);
  const CampaignProposal proposal = write("slope.h5");
  const Campaign campaign = read_campaign(folder / "campaign.toml");
  ASSERT_EQ(campaign.ground.size(), 4u);
  EXPECT_EQ(campaign.ground.at("upper cliff").friction->central_value(),
            ground_type("rock").friction.value);
  EXPECT_EQ(campaign.ground.at("deep \"wet\" meadow").rolling_friction->central_value(),
            ground_type("soil medium").rolling_friction.value);
  EXPECT_EQ(campaign.ground.at("éboulis").energy_restitution->central_value(),
            ground_type("talus").energy_restitution.value);
  EXPECT_EQ(campaign.ground.at("a.b").rolling_friction->central_value(),
            default_ground_type().rolling_friction.value);
  ASSERT_EQ(proposal.proposal_warnings.size(), 1u);
  EXPECT_TRUE(contains(proposal.proposal_warnings[0], "1 ground zone is taken"));
}

TEST_F(NewCampaigns, PathsAreRelativeToTheCampaign) {
  write_slope(folder / "in put" / "slope.asc", {});
  write_new_campaign(folder / "blocks.h5", {folder / "in put" / "slope.asc"},
                     folder / "out" / "campaign.toml");
  const std::string written = read_text_file(folder / "out" / "campaign.toml");
  EXPECT_TRUE(contains(written, "\"../blocks.h5\"") && contains(written, "\"../in put/slope.asc\""))
      << written;
  fs::rename(folder.path() / "out", folder.path() / "else");
  EXPECT_NO_THROW(prepare_campaign(read_campaign(folder / "else" / "campaign.toml")));
}

TEST_F(NewCampaigns, BlocksWithoutASizeGetAMassThatIsSaidToBeAnAssumption) {
  write_slope(folder / "slope.asc", {});
  BlockLibrary library = BlockLibrary::read(folder / "blocks.h5"), unscaled, mixed = library;
  for (Block block : library.blocks()) {
    block.source.unscaled = true;
    unscaled.add(block);
    block.id += "_model";
    mixed.add(block);
  }
  unscaled.write(folder / "unscaled.h5");
  mixed.write(folder / "mixed.h5");

  const CampaignProposal proposal = write("slope.asc", "unscaled.h5");
  EXPECT_EQ(proposal.blocks.mass, 1000.0);
  EXPECT_TRUE(contains(text(), "scale              = { mass_kg = 1000 }")) << text();
  EXPECT_TRUE(contains(text(), "no scale")) << text();
  for (const BlockSummary& block :
       prepare_campaign(read_campaign(folder / "campaign.toml")).header.blocks) {
    EXPECT_NEAR(block.mass, 1000.0, 1e-6);
  }

  const CampaignProposal some = write("slope.asc", "mixed.h5");
  EXPECT_EQ(some.blocks.count, 3u);
  EXPECT_EQ(some.blocks.selected, (std::vector<std::string>{"bar", "cube", "slab"}));
  EXPECT_EQ(some.blocks.omitted_blocks.size(), 3u);
  EXPECT_EQ(read_campaign(folder / "campaign.toml").blocks.filter.ids, some.blocks.selected);
}

TEST_F(NewCampaigns, BlocksTooLargeForTheTerrainAreLeftOut) {
  write_slope(folder / "slope.asc", {.cells = 60, .cell = 0.25});  // 15 m
  const CampaignProposal proposal = write("slope.asc");
  EXPECT_EQ(proposal.blocks.selected, (std::vector<std::string>{"cube", "slab"}));
  EXPECT_TRUE(contains(text(), "left out: bar is 1.6")) << text();
  write_slope(folder / "slope.asc", {.cells = 40, .cell = 0.1});
  fs::remove(folder / "campaign.toml");
  EXPECT_TRUE(contains(refusal_of("slope.asc"), "no block of the library fits"));
}

TEST_F(NewCampaigns, FitATerrainOfOneTriangle) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 60}, {100, 0, 0}, {0, 100, 60}};
  mesh.triangles = {{0, 1, 2}};
  write_obj(folder / "one.obj", mesh);
  const CampaignProposal proposal = write("one.obj");
  EXPECT_GT(proposal.places.downslope.x(), 0.9);
  const CampaignPlan prepared = prepare_campaign(read_campaign(folder / "campaign.toml"));
  EXPECT_FALSE(prepared.runs.empty());
}

TEST_F(NewCampaigns, AreRefusedWhereNoneMakesSense) {
  write_slope(folder / "slope.asc", {});
  write_slope(folder / "flat.asc", {.slope = 0.0});
  BlockLibrary().write(folder / "empty.h5");
  const std::string empty = refusal_of("slope.asc", "empty.h5");
  EXPECT_TRUE(contains(empty, "empty.h5") && contains(empty, "no block")) << empty;
  const std::string flat = refusal_of("flat.asc");
  EXPECT_TRUE(contains(flat, "flat.asc") && contains(flat, "degrees")) << flat;
  EXPECT_TRUE(contains(refusal_of("slope.asc", "none.h5"), "none.h5"));
  EXPECT_TRUE(contains(refusal_of("none.asc"), "none.asc"));
  EXPECT_TRUE(contains(refusal_of("slope.asc", "slope.asc"), "slope.asc"));
}

TEST_F(NewCampaigns, KeepAFileThatIsThere) {
  write_slope(folder / "slope.asc", {});
  const std::string campaign = "[blocks]\nlibrary = \"b.h5\"\n[terrain]\nsurface = \"s.h5\"\n";
  for (const auto& [content, replace, why] :
       {std::tuple(std::string("# mine\n"), true, "holds \"text\", not \"campaign\""),
        {campaign, false, "`replace`"}}) {
    write_text_file(folder / "mine.toml", content);
    const std::string text = refusal<InputError>([&, with = replace] {
      write_new_campaign(folder / "blocks.h5", {folder / "slope.asc"}, folder / "mine.toml",
                         {.replace = with});
    });
    EXPECT_TRUE(contains(text, "mine.toml") && contains(text, why)) << text;
    EXPECT_EQ(read_text_file(folder / "mine.toml"), content);
  }
}

TEST_F(NewCampaigns, AreTheSameEveryTime) {
  write_slope(folder / "slope.asc", {.facing = 4.0});
  write("slope.asc");
  const std::string first = text();
  write("slope.asc");
  EXPECT_EQ(text(), first);
}

}  // namespace
}  // namespace clast
