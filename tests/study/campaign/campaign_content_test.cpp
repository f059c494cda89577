// What a campaign can hold: release sets, drawn and scaled blocks, block groups, uncertain ground.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/statistics/probability.hpp"
#include "study/results/block_stiffness.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

using CampaignContent = CampaignRun;

const std::string kPoints =
    "points = [[-12, -3, 9.5], [-12, 3, 9.5]]\norientations = \"turns.txt\"";

TEST_F(CampaignContent, SeveralReleaseSetsRunOneAfterTheOther) {
  const std::string text = with("[release]\n" + kPoints, R"([[release]]
name = "crest"
points = [[-12, -3, 9.5], [-12, 3, 9.5]]
orientations = "turns.txt"
[[release]]
name = "bench"
points = [[-5, 0]]
height_m = 1.0
velocity_m_s = [2, 0, 0]
orientations = { random = 2, seed = 3 })");
  const CampaignPlan plan = prepared(text);
  ASSERT_EQ(plan.runs.size(), 2u * (2u * 3u + 1u * 2u));
  EXPECT_EQ(plan.header.release_sets, (std::vector<std::string>{"crest", "bench"}));
  EXPECT_EQ(plan.header.set_of_point, (std::vector<std::uint32_t>{0, 0, 1}));
  ASSERT_EQ(plan.header.release_points.size(), 3u);
  for (std::uint32_t i = 0; i < plan.runs.size(); ++i) {
    const RunRecord& run = plan.runs[i];
    EXPECT_EQ(run.run, i);
    EXPECT_EQ(run.block, i / 8);
    EXPECT_EQ(run.point, i % 8 < 6 ? i % 8 / 3 : 2);
    EXPECT_EQ(run.start.velocity.x(), run.point == 2 ? 2.0 : 0.0);
  }
  EXPECT_NEAR(plan.header.frame.to_map(plan.runs[6].start.position).x(), -5.0, 1e-12);
  EXPECT_TRUE(contains(refusal(with("[release]\n" + kPoints, R"([[release]]
name = "a"
points = [[-12, -3, 9.5]]
orientations = "turns.txt"
[[release]]
name = "b"
points = [[-12, 3, 9.5], [-12, 3, 7.4]]
orientations = "turns.txt")")),
                       "run 6, block cube, release set b, release point 2, orientation 1: starts"));
}

TEST_F(CampaignContent, FreshOrientationsDifferForEveryBlockAndPoint) {
  const CampaignPlan plan =
      prepared(with("\"turns.txt\"", "{ random = 2, seed = 5, fresh = true }"));
  ASSERT_EQ(plan.runs.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_LT(std::abs(plan.runs[i].start.orientation.dot(plan.runs[k].start.orientation)),
                0.999);
    }
  }
  const CampaignPlan again =
      prepared(with("\"turns.txt\"", "{ random = 2, seed = 5, fresh = true }"));
  EXPECT_EQ(plan.runs[7].start.orientation.coeffs(), again.runs[7].start.orientation.coeffs());
}

TEST_F(CampaignContent, EqualMassScalesLengthsByTheCubeRootOfTheMassRatio) {
  const CampaignPlan own = prepared();
  const CampaignPlan equal = prepared(with("[terrain]", "scale = \"equal-mass\"\n[terrain]"));
  const double mean = 0.5 * (own.bodies[0].mass + own.bodies[1].mass);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(equal.bodies[i].mass, mean, 1e-9 * mean);
    EXPECT_NEAR(equal.header.blocks[i].mass, mean, 1e-9 * mean);
    const double scale = std::cbrt(mean / own.bodies[i].mass);
    EXPECT_NEAR(equal.header.blocks[i].scale, scale, 1e-12);
    // Inertia goes with the fifth power of length.
    const Vec3 moments = std::pow(scale, 5) * own.bodies[i].moments;
    EXPECT_LT((equal.bodies[i].moments - moments).norm(), 1e-9 * moments.norm());
    EXPECT_NEAR(equal.bodies[i].shape.radius, scale * 0.05, 1e-12);
    EXPECT_NEAR(equal.header.blocks[i].axes.L, scale * own.header.blocks[i].axes.L, 1e-12);
    EXPECT_EQ(equal.header.blocks[i].garcia, own.header.blocks[i].garcia);
  }
  const CampaignPlan mass = prepared(with("[terrain]", "scale = { mass_kg = 500 }\n[terrain]"));
  EXPECT_NEAR(mass.bodies[1].mass, 500.0, 1e-9);
  const CampaignPlan volume = prepared(with("[terrain]", "scale = { volume_m3 = 0.5 }\n[terrain]"));
  EXPECT_NEAR(volume.header.blocks[0].volume, 0.5, 1e-12);
  EXPECT_NEAR(volume.header.blocks[0].mass, 0.5 * 2650.0, 1e-6);
}

TEST_F(CampaignContent, DrawnBlocksHaveTheAskedSharesAndMasses) {
  const CampaignPlan plan = prepared(with("[terrain]", R"([blocks.draw]
count = 41
seed = 7
shares = { compact = 0.25, elongated = 0.75 }
mass_kg = { log_normal = [300, 0.5] }
[terrain])"));
  ASSERT_EQ(plan.bodies.size(), 41u);
  std::map<std::string, std::size_t> classes;
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < 41; ++i) {
    const BlockSummary& block = plan.header.blocks[i];
    ++classes[block.garcia];
    EXPECT_EQ(block.id, block.library_id + "#" + std::to_string(i + 1));
    EXPECT_EQ(block.library_id, block.garcia == "compact" ? "cube" : "slab");
    const double log = std::log(plan.bodies[i].mass / 300.0);
    sum += log;
    squares += log * log;
  }
  // 10.25 and 30.75: the larger remainder gets the odd one.
  EXPECT_EQ(classes["compact"], 10u);
  EXPECT_EQ(classes["elongated"], 31u);
  // Mean within four standard errors, spread within four of its own.
  EXPECT_NEAR(sum / 41, 0.0, 4 * 0.5 / std::sqrt(41.0));
  EXPECT_NEAR(std::sqrt(squares / 41), 0.5, 4 * 0.5 / std::sqrt(82.0));
  EXPECT_EQ(plan.choice.library.size(), 2u);
}

TEST_F(CampaignContent, ClassWithoutABlockIsNotDrawn) {
  EXPECT_TRUE(contains(refusal(with("[terrain]", R"(select = ["cube"]
draw = { count = 4, shares = { elongated = 1.0 } }
[terrain])")),
                       "asks for blocks of class \"elongated\" by garcia, but none is selected"));
}

TEST(Quotas, AddUpAndFollowTheLargestRemainder) {
  EXPECT_EQ(allocate_quotas({0.5, 0.3, 0.2}, 7),
            (std::vector<std::size_t>{4, 2, 1}));  // 3.5, 2.1, 1.4
  EXPECT_EQ(allocate_quotas({1.0}, 3), (std::vector<std::size_t>{3}));
  EXPECT_EQ(allocate_quotas({0.4, 0.6}, 0), (std::vector<std::size_t>{0, 0}));
}

TEST_F(CampaignContent, BlockGroupHasItsOwnGround) {
  const CampaignPlan plan = prepared(campaign_text() + R"([[block_group]]
name = "schist"
select = ["slab"]
ground.slope = { friction = 0.25 }
)");
  ASSERT_EQ(plan.header.ground_sets.size(), 2u);
  const GroundParameterSet& schist = plan.header.ground_sets[1];
  EXPECT_EQ(schist.group, "schist");
  EXPECT_EQ(schist.zones[0].friction, 0.25);
  EXPECT_EQ(schist.zones[0].rolling_friction, 0.1);
  EXPECT_EQ(schist.zones[1].friction, 0.6);
  EXPECT_EQ(plan.header.ground_sets[0].zones[0].friction, 0.4);
  EXPECT_EQ(plan.header.blocks[1].group, "schist");
  for (const RunRecord& run : plan.runs) EXPECT_EQ(run.ground_set, run.block);
  // A run does what it does alone under those parameters.
  const CampaignPlan alone = prepared(with("friction = 0.4", "friction = 0.25"));
  const auto first_of_slab = [&](const CampaignPlan& campaign) {
    const RunRecord& run = campaign.runs[6];
    ReleaseSettings settings = release_settings(campaign.campaign, run);
    settings.max_time = 2.0;
    return simulate_release(*campaign.surface, campaign.header.ground_sets[run.ground_set].zones,
                            campaign.bodies[run.block], run.start, settings)
        .final_state.position;
  };
  EXPECT_EQ(first_of_slab(plan), first_of_slab(alone));
}

TEST_F(CampaignContent, RollingLengthIsOfAZoneAndNeedNotBeStated) {
  const CampaignPlan plan =
      prepared(with("rolling_friction = 0.3", "rolling_friction = 0.3\nrolling_length_m = 0.1") +
               "[[block_group]]\nname = \"schist\"\nselect = [\"slab\"]\n"
               "ground.slope = { rolling_length_m = 0.2 }\n");
  ASSERT_EQ(plan.header.ground_sets.size(), 2u);
  EXPECT_EQ(plan.header.ground_sets[0].zones[0].rolling_length, 0.0);
  EXPECT_EQ(plan.header.ground_sets[0].zones[1].rolling_length, 0.1);
  EXPECT_EQ(plan.header.ground_sets[1].zones[0].rolling_length, 0.2);
  EXPECT_EQ(plan.header.ground_sets[1].zones[1].rolling_length, 0.1);
  // k_r by zone: k_t (S/2)^2, or k_n a^2 where a is stated.
  const double k_n = plan.runs.front().stiffness.normal;
  const double arm = 0.5 * plan.header.blocks.front().axes.S;
  const ValueRange k_r = collect_stiffness_by_block(plan.header, plan.runs).front().values[2].range;
  EXPECT_NEAR(k_r.low, k_n * std::min(0.01, arm * arm), 1e-6 * k_n);
  EXPECT_NEAR(k_r.high, k_n * std::max(0.01, arm * arm), 1e-6 * k_n);
}

TEST_F(CampaignContent, SoilOfAZoneReachesItsRunsAndMustGoTogether) {
  const auto soil = [](const std::string& keys) {
    return with("rolling_friction = 0.3", "rolling_friction = 0.3\n" + keys);
  };
  const CampaignPlan plan =
      prepared(soil("friction_min = 0.1\nslip_growth_per_m = { uniform = [2.0, 4.0] }\n"
                    "slip_memory_s = 0.005\nscar_drag = 1.5\nsoil_density_kg_m3 = 1800") +
               "[ensemble]\nmembers = 3\n");
  for (const GroundParameterSet& set : plan.header.ground_sets) {
    EXPECT_EQ(set.zones[0].slip_growth, 0.0);
    EXPECT_GT(set.zones[1].slip_growth, 2.0);
    EXPECT_LT(set.zones[1].slip_growth, 4.0);
    EXPECT_EQ(set.zones[1].friction_min, 0.1);
    EXPECT_EQ(set.zones[1].slip_memory, 0.005);
    EXPECT_EQ(set.zones[1].scar_drag, 1.5);
    EXPECT_EQ(set.zones[1].soil_density, 1800.0);
  }
  EXPECT_TRUE(contains(refusal(soil("friction_min = 0.1")), "slip_growth = 0; must be above 0"));
  EXPECT_TRUE(contains(refusal(soil("scar_drag = 1.5")), "soil_density = 0; must be above 0"));
  EXPECT_TRUE(contains(refusal(soil("friction_min = 90\nslip_growth_per_m = 1")),
                       "friction_min = 90; must be at most friction"));
}

TEST_F(CampaignContent, SoilRemembersBetweenReleasesUnderALawThatLeavesDents) {
  const std::string soil =
      with("rolling_friction = 0.3", "rolling_friction = 0.3\nsoil_memory_m = 0.2");
  EXPECT_TRUE(contains(refusal(soil),
                       "soil_memory_m applies to blocks that follow each other; add "
                       "[release] sequence = \"stay\""));
  const std::string stay =
      replaced_once(soil, "[release]\n", "[release]\nsequence = \"stay\"\n") +
      "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.1\n";
  EXPECT_TRUE(contains(refusal(stay), "soil_memory_m needs [contact] law = \"elastoplastic\""));
  const CampaignPlan plan = prepared(stay + "[contact]\nlaw = \"elastoplastic\"\n");
  EXPECT_EQ(plan.header.ground_sets[0].zones[1].soil_memory, 0.2);
  EXPECT_EQ(plan.header.ground_sets[0].zones[0].soil_memory, 0.0);
}

TEST_F(CampaignContent, BlockGroupsThatDoNotFitAreRefused) {
  const std::string group = "[[block_group]]\nname = \"g\"\nground.slope = { friction = 0.2 }\n";
  EXPECT_TRUE(contains(refusal(with("[terrain]", "select = [\"cube\"]\n[terrain]") + group +
                               "select = [\"slab\"]\n"),
                       "the block group \"g\" holds no block of the campaign"));
  EXPECT_TRUE(contains(refusal(campaign_text() + group + "select = [\"slab\"]\n" +
                               replaced_once(group, "\"g\"", "\"h\"") +
                               "select = { scheme = \"garcia\", class = \"elongated\" }\n"),
                       "block slab is in the block groups \"g\" and \"h\""));
}

TEST_F(CampaignContent, EnsembleDrawsTheGroundForEveryMember) {
  const std::string text = with("friction = 0.4", "friction = { uniform = [0.3, 0.5] }");
  std::string ensemble =
      replaced_once(text, "rolling_friction = 0.3", "rolling_friction = { normal = [0.3, 0.05] }");
  ensemble += "[ensemble]\nmembers = 50\nseed = 9\n";
  const CampaignPlan plan = prepared(ensemble);
  ASSERT_EQ(plan.header.ground_sets.size(), 50u);
  ASSERT_EQ(plan.runs.size(), 12u * 50u);
  double friction = 0.0, rolling = 0.0;
  for (std::uint32_t member = 0; member < 50; ++member) {
    const GroundParameterSet& set = plan.header.ground_sets[member];
    EXPECT_EQ(set.member, member);
    EXPECT_GE(set.zones[0].friction, 0.3);
    EXPECT_LT(set.zones[0].friction, 0.5);
    EXPECT_EQ(set.zones[1].friction, 0.6);
    friction += set.zones[0].friction / 50;
    rolling += set.zones[1].rolling_friction / 50;
  }
  // Within four standard errors of the mean.
  EXPECT_NEAR(friction, 0.4, 4 * 0.2 / std::sqrt(12.0 * 50));
  EXPECT_NEAR(rolling, 0.3, 4 * 0.05 / std::sqrt(50.0));
  EXPECT_EQ(plan.header.ground[0].friction, 0.4);
  for (std::uint32_t i = 0; i < plan.runs.size(); ++i) {
    EXPECT_EQ(plan.runs[i].ground_set, i % 50);
    EXPECT_EQ(plan.runs[i].start.position, plan.runs[i / 50 * 50].start.position);
  }
  // The same seed draws the same.
  EXPECT_EQ(prepared(ensemble).header.ground_sets[49].zones[0].friction,
            plan.header.ground_sets[49].zones[0].friction);
}

// Of 32 members of Sobol's sequence each 32nd part of every parameter's law has one.
TEST_F(CampaignContent, SobolEnsembleFillsTheLawsEvenly) {
  std::string text = with("friction = 0.4", "friction = { uniform = [0.3, 0.5] }");
  text =
      replaced_once(text, "rolling_friction = 0.3", "rolling_friction = { normal = [0.3, 0.05] }");
  text +=
      "[[block_group]]\nname = \"g\"\nselect = [\"slab\"]\n"
      "ground.slope = { friction = { uniform = [0.1, 0.2] } }\n"
      "[ensemble]\nmembers = 32\nseed = 9\ndesign = \"sobol\"\n";
  const CampaignPlan plan = prepared(text);
  ASSERT_EQ(plan.header.ground_sets.size(), 64u);
  std::set<int> friction, rolling, of_group;
  for (std::uint32_t member = 0; member < 32; ++member) {
    const GroundParameterSet& set = plan.header.ground_sets[member];
    const GroundParameterSet& group = plan.header.ground_sets[32 + member];
    friction.insert(static_cast<int>((set.zones[0].friction - 0.3) / 0.2 * 32));
    rolling.insert(static_cast<int>(normal_cdf((set.zones[1].rolling_friction - 0.3) / 0.05) * 32));
    of_group.insert(static_cast<int>((group.zones[0].friction - 0.1) / 0.1 * 32));
    EXPECT_EQ(group.zones[1].rolling_friction, set.zones[1].rolling_friction);
  }
  EXPECT_EQ(friction.size(), 32u);
  EXPECT_EQ(rolling.size(), 32u);
  EXPECT_EQ(of_group.size(), 32u);
}

TEST(Distribution, QuantilesAreThoseOfTheLaw) {
  EXPECT_EQ((Distribution{Distribution::Law::kFixed, 0.7}.quantile(0.2)), 0.7);
  EXPECT_DOUBLE_EQ((Distribution{Distribution::Law::kUniform, 1.0, 3.0}.quantile(0.25)), 1.5);
  const Distribution normal{Distribution::Law::kNormal, 2.0, 0.5};
  EXPECT_NEAR(normal.quantile(0.975), 2.0 + 1.959963985 * 0.5, 1e-8);
  const Distribution log_normal{Distribution::Law::kLogNormal, 300.0, 0.5};
  EXPECT_NEAR(log_normal.quantile(0.5), 300.0, 1e-9);
  EXPECT_NEAR(log_normal.quantile(0.1), 300.0 * std::exp(-1.281551566 * 0.5), 1e-6);
  // Cut at its mean, the upper half is left, whose median is the upper quartile.
  const Distribution cut{Distribution::Law::kNormal, 0.0, 1.0, 0.0, 1e300};
  EXPECT_NEAR(cut.quantile(0.5), 0.6744897502, 1e-8);
  EXPECT_GE(cut.quantile(0.0), 0.0);
}

TEST(Distribution, DrawsFollowTheirLaw) {
  Random random(3);
  const Distribution normal{Distribution::Law::kNormal, 0.1, 0.2, 0.0, 1.0};
  double minimum = 1.0;
  for (int i = 0; i < 1000; ++i) {
    const double value = normal.draw(random);
    EXPECT_GT(value, 0.0);
    EXPECT_LE(value, 1.0);
    minimum = std::min(minimum, value);
  }
  EXPECT_LT(minimum, 0.01);
  const Distribution log_normal{Distribution::Law::kLogNormal, 300.0, 0.5};
  EXPECT_EQ(log_normal.central_value(), 300.0);
  EXPECT_EQ((Distribution{Distribution::Law::kUniform, 1.0, 2.0}.central_value()), 1.5);
  EXPECT_EQ((Distribution{Distribution::Law::kFixed, 0.7}.draw(random)), 0.7);
}

}  // namespace
}  // namespace clast
