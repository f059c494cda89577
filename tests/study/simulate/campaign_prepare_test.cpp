#include "study/simulate/campaign_runner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <regex>

#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/search/ground_overlap.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

bool plan_warns(const CampaignPlan& plan, const std::string& text) {
  return std::any_of(plan.header.warnings.begin(), plan.header.warnings.end(),
                     [&](const std::string& warning) { return contains(warning, text); });
}

TEST_F(CampaignRun, PlansEveryBlockPointAndOrientationInOrder) {
  const CampaignPlan plan = prepared();
  ASSERT_EQ(plan.runs.size(), 2u * 2u * 3u);
  EXPECT_EQ(plan.header.planned_runs, 12u);
  for (std::uint32_t i = 0; i < 12; ++i) {
    EXPECT_EQ(plan.runs[i].run, i);
    EXPECT_EQ(plan.runs[i].block, i / 6);
    EXPECT_EQ(plan.runs[i].point, i / 3 % 2);
    EXPECT_EQ(plan.runs[i].orientation, i % 3);
  }
  EXPECT_EQ(plan.header.zone_names, (std::vector<std::string>{"slope", "flat"}));
  EXPECT_EQ(plan.header.ground[1].rolling_friction, 0.3);
  EXPECT_EQ(plan.header.inputs.size(), 4u);
  // Points are of the centre of mass, on the map.
  const Vec3 start = plan.header.frame.to_map(plan.runs[4].start.position);
  EXPECT_LT((start - Vec3(-12, 3, 9.5)).norm(), 1e-12);
  // The only bound there is for a body that starts at rest: the fall to the lowest ground.
  const double fastest = std::sqrt(2 * 9.81 * 9.5);
  for (const RunRecord& run : plan.runs) {
    const RigidBody body = plan.bodies[run.block];
    const StiffnessChoice expected =
        choose_stiffness(std::span(&body, 1), plan.header.ground, fastest, 9.81, {});
    EXPECT_NEAR(run.stiffness.normal, expected.stiffness.normal, 1e-9 * expected.stiffness.normal);
  }
}

TEST_F(CampaignRun, QuaternionFileTurnsTheBlockAsItsSourceHoldsIt) {
  const CampaignPlan plan = prepared();
  for (const RunRecord& run : plan.runs) {
    const Block& block = plan.choice.library[plan.choice.blocks[run.block].library];
    const RigidBody body = plan.bodies[run.block];
    const Quat& turn = plan.campaign.releases[0].orientations[run.orientation];
    for (std::size_t i = 0; i < body.shape.vertices.size(); ++i) {
      const Vec3 placed = run.start.world_from_body() * body.shape.vertices[i];
      const Vec3 expected =
          run.start.position + turn * (block.body.vertices[i] - block.mass.centre);
      ASSERT_LT((placed - expected).norm(), 1e-12);
    }
  }
  const CampaignPlan principal =
      prepared(with("\"turns.txt\"", "\"turns.txt\"\nframe = \"principal\""));
  EXPECT_EQ(principal.runs[1].start.orientation.coeffs(),
            principal.campaign.releases[0].orientations[1].coeffs());
}

TEST_F(CampaignRun, DropHeightIsTheClearanceOfTheLowestSkinPoint) {
  const CampaignPlan plan = prepared(with("points = [[-12, -3, 9.5], [-12, 3, 9.5]]",
                                          "points = [[-12, -3], [10, 3]]\nheight_m = 0.75"));
  for (const RunRecord& run : plan.runs) {
    const RigidBody body = plan.bodies[run.block];
    double clearance = 1e9;
    for (const Vec3& vertex : body.shape.vertices) {
      const Vec3 point = plan.header.frame.to_map(run.start.world_from_body() * vertex);
      const double ground = point.x() < 0 ? -0.6 * point.x() : 0.0;
      clearance = std::min(clearance, point.z() - body.shape.radius - ground);
    }
    EXPECT_NEAR(clearance, 0.75, 1e-9);
    EXPECT_NEAR(plan.header.frame.to_map(run.start.position).x(), run.point == 0 ? -12.0 : 10.0,
                1e-12);
  }
}

TEST_F(CampaignRun, GridDuplicatesAreCounted) {
  const CampaignPlan plan = prepared(with("\"turns.txt\"", "\"grid-45\""));
  ASSERT_EQ(plan.campaign.releases[0].orientations.size(), 64u);
  // By another measure than the quaternions: rotation matrices, compared entry by entry.
  std::vector<Mat3> distinct;
  for (const Quat& turn : plan.campaign.releases[0].orientations) {
    const Mat3 matrix = turn.toRotationMatrix();
    bool known = false;
    for (const Mat3& other : distinct) known |= (matrix - other).cwiseAbs().maxCoeff() < 1e-9;
    if (!known) distinct.push_back(matrix);
  }
  EXPECT_TRUE(plan_warns(plan, "64 orientations, of which " + std::to_string(distinct.size())));
  EXPECT_LT(distinct.size(), 64u);
}

TEST_F(CampaignRun, BarrierThatCountsUphillOnlyIsNamed) {
  const auto warned = [](const std::string& ends) {
    return plan_warns(prepared(with("from = [0, -20]\nto = [0, 20]", ends)),
                      "barrier foot counts only crossings from the left");
  };
  EXPECT_FALSE(warned("from = [0, 20]\nto = [0, -20]")) << "either direction counts";
  EXPECT_FALSE(warned("from = [0, -20]\nto = [0, 20]\ndirection = \"forward\""));
  EXPECT_TRUE(warned("from = [0, 20]\nto = [0, -20]\ndirection = \"forward\""));
}

TEST_F(CampaignRun, BarrierOffTheTerrainIsNamed) {
  const std::string off = "barrier foot is outside the terrain";
  EXPECT_FALSE(plan_warns(prepared(), off));
  EXPECT_TRUE(plan_warns(
      prepared(with("from = [0, -20]\nto = [0, 20]", "from = [0, 21]\nto = [9, 30]")), off));
}

TEST_F(CampaignRun, ReleasePointsThatRepeatAnotherAreCounted) {
  const std::string points = "points = [[-12, -3, 9.5], [-12, 3, 9.5]]";
  EXPECT_FALSE(plan_warns(prepared(), "repeat another"));
  EXPECT_TRUE(plan_warns(
      prepared(with(points, "height_m = 1\npoints = [[-12, 0], [10, 1], [-12, 0, 7], [-12, 0]]")),
      "2 of 4 release points repeat another"))
      << "with height_m the heights of points say nothing";
}

TEST_F(CampaignRun, AnAngleInThePlaceOfAFrictionCoefficientIsNamed) {
  EXPECT_FALSE(plan_warns(prepared(), "is a coefficient"));
  EXPECT_TRUE(plan_warns(prepared(with("friction = 0.4", "friction = 35")),
                         "[ground.slope] friction = 35 is a coefficient; that of an angle of 35 "
                         "degrees is its tangent"));
}

TEST_F(CampaignRun, RunsThatWouldNotEndAreRefusedAndLongOnesNamed) {
  const auto stepped = [](const char* step) {
    return with("[terrain]", std::string("[contact]\ntime_step_s = ") + step + "\n[terrain]");
  };
  // The shortest step and the longest run that the campaign's ranges allow.
  const std::string endless =
      std::regex_replace(stepped("1e-9"), std::regex("max_time_s = [0-9.]+"), "max_time_s = 1e5");
  EXPECT_TRUE(contains(refusal(endless), "time step of 1e-09 s makes up to 1e+14 steps"));
  EXPECT_TRUE(
      contains(clast::refusal([&] { campaign(stepped("1e-30")); }), "must be from 1e-09 to 1 s"));
  EXPECT_TRUE(plan_warns(prepared(stepped("1e-9")), "time step of 1e-09 s makes up to"));
}

TEST_F(CampaignRun, AProbeDoesNotWaitForARunWithoutEnd) {
  const CampaignPlan campaign =
      prepared(with("[terrain]", "[contact]\ntime_step_s = 1e-9\n[terrain]"));
  const RunTimeProbe probe = measure_run_time(campaign, 0.02);
  EXPECT_TRUE(probe.last_run_stopped);
  EXPECT_TRUE(probe.is_upper_bound);
  EXPECT_EQ(probe.runs, 1u);
  // 1e9 steps and more for a second on the ground, each of 10 ns at the very least.
  EXPECT_GT(probe.time_per_run, 100.0);
}

TEST_F(CampaignRun, ManyOrientationsAreToldApartWithoutComparingEachWithEach) {
  std::string turns;
  Random random(4);
  for (int i = 0; i < 60'000; ++i) {
    const Quat q = random.rotation();
    for (const double part : {q.w(), q.x(), q.y(), q.z()}) turns += std::to_string(part) + " ";
    turns += "\n";
    if (i == 100) turns += turns;
  }
  write_text_file(*folder_ / "many.txt", turns);
  const double begin = static_cast<double>(std::clock());
  const CampaignPlan plan = prepared(with("turns.txt", "many.txt"));
  const double seconds = (static_cast<double>(std::clock()) - begin) / CLOCKS_PER_SEC;
  EXPECT_TRUE(plan_warns(plan, "60101 orientations, of which 60000 are different rotations"));
  EXPECT_LT(seconds, 10.0);
}

TEST_F(CampaignRun, BlocksAreSelectedByIdAndClass) {
  const CampaignPlan one = prepared(with("[terrain]", "select = [\"slab\"]\n[terrain]"));
  ASSERT_EQ(one.choice.blocks.size(), 1u);
  EXPECT_EQ(one.choice.blocks[0].id, "slab");
  const CampaignPlan elongated = prepared(
      with("[terrain]", "select = { scheme = \"garcia\", class = \"elongated\" }\n[terrain]"));
  ASSERT_EQ(elongated.choice.blocks.size(), 1u);
  EXPECT_EQ(elongated.choice.blocks[0].id, "slab");
  EXPECT_TRUE(contains(refusal(with("[terrain]", "select = [\"slap\"]\n[terrain]")), "slap"));
  EXPECT_TRUE(contains(
      refusal(with("[terrain]", "select = { scheme = \"zingg\", class = \"rod\" }\n[terrain]")),
      "selects no block of"));
}

TEST_F(CampaignRun, ZonesAndParametersMustFit) {
  const std::string missing = refusal(with("[ground.flat]", "[ground.flt]"));
  EXPECT_TRUE(contains(missing,
                       "campaign.toml: terrain zone \"flat\" has no parameters; add "
                       "[ground.flat] to [ground.flt], [ground.slope]"))
      << missing;
  const std::string unused =
      refusal(campaign_text() +
              "[ground.scree]\nenergy_restitution = 1\nfriction = 1\nrolling_friction = 1\n");
  EXPECT_TRUE(contains(unused,
                       "[ground.scree] belongs to no zone of the terrain; its zones are "
                       "slope, flat"))
      << unused;
}

TEST_F(CampaignRun, FallsFasterThanAnyRockAreRefused) {
  const std::string message = refusal(with("[-12, 3, 9.5]", "[-12, 3, 90000]"));
  EXPECT_TRUE(contains(message, "release point 2 is 9")) << message;
  EXPECT_TRUE(contains(message,
                       "m/s; at most 1000 m/s make sense: check heights, units and "
                       "gravity_m_s2"))
      << message;
}

TEST_F(CampaignRun, ReleaseOffTheTerrainIsRefused) {
  const std::string message = refusal(with("[-12, 3, 9.5]", "[-12, 33, 9.5]"));
  EXPECT_TRUE(contains(message,
                       "release point 2 at x -12.000, y 33.000 is off the terrain, which lies in x "
                       "-20.000 to 30.000, y -20.000 to 20.000"))
      << message;
  write_text_file(*folder_ / "gap.stl", plane_stl(5, 30, 0.0));
  std::string gap = with("\"flat.stl\"", "\"gap.stl\"");
  const std::string point = "[-12, 3, 9.5]";
  gap.replace(gap.find(point), point.size(), "[2, 3, 9.5]");
  EXPECT_TRUE(contains(refusal(gap), "y 3.000 is over a hole in the terrain, which lies in"));
}

TEST_F(CampaignRun, StartInsideTheGroundIsRefused) {
  // Ground at 7.2 m; the cube reaches 0.35 m down.
  const std::string touching = refusal(with("[-12, 3, 9.5]", "[-12, 3, 7.4]"));
  EXPECT_TRUE(contains(touching, "run 3, block cube, release point 2, orientation 1: starts 0."))
      << touching;
  EXPECT_TRUE(
      contains(touching, "m inside the ground, with its centre at x -12.000, y 3.000, z 7.400"))
      << touching;
  const std::string buried = refusal(with("[-12, 3, 9.5]", "[-12, 3, 2]"));
  EXPECT_TRUE(contains(buried, "run 3, block cube, release point 2, orientation 1: starts 5."))
      << buried;
}

TEST_F(CampaignRun, ARestitutionOfSpeedIsQuestioned) {
  const auto with_restitution = [](const std::string& value) {
    return prepared(with("energy_restitution = 0.1", "energy_restitution = " + value));
  };
  EXPECT_TRUE(plan_warns(with_restitution("0.53"),
                         "[ground.slope] energy_restitution = 0.53 is the fraction of energy that "
                         "an impact returns, e_n^2; usual ground returns up to 0.28. If it is a "
                         "coefficient of restitution of velocity, R_n, give its square, 0.28"));
  EXPECT_TRUE(plan_warns(with_restitution("0.35"), "give its square, 0.12"));
  for (const char* plain : {"0.01", "0.1", "0.28", "1"}) {
    EXPECT_FALSE(plan_warns(with_restitution(plain), "give its square")) << plain;
  }
}

TEST_F(CampaignRun, AHeightOfZeroStartsInTouch) {
  const CampaignPlan low = prepared(
      with("points = [[-12, -3, 9.5], [-12, 3, 9.5]]", "points = [[-12, -3]]\nheight_m = 0"));
  const CampaignPlan high = prepared(
      with("points = [[-12, -3, 9.5], [-12, 3, 9.5]]", "points = [[-12, -3]]\nheight_m = 2"));
  ASSERT_EQ(low.runs.size(), high.runs.size());
  for (std::size_t i = 0; i < low.runs.size(); ++i) {
    const RigidBody body = low.bodies[low.runs[i].block];
    const GroundOverlap overlap(*low.surface, body);
    RigidState start = low.runs[i].start;
    EXPECT_LT(overlap.max_overlap(start), 1e-5 * body.smallest_side) << i;
    start.position.z() -= 1e-4 * body.smallest_side;
    EXPECT_GT(overlap.max_overlap(start), 0.0) << i << " is on the ground";
    const Vec3 lifted = high.runs[i].start.position - low.runs[i].start.position;
    EXPECT_NEAR(lifted.head<2>().norm(), 0.0, 1e-12);
    EXPECT_LE(lifted.z(), 2.0 + 1e-9) << "heights are measured under the vertices";
    EXPECT_GT(lifted.z(), 1.5);
  }
}

TEST_F(CampaignRun, BlocksBeyondTheUsualSizesAreRefusedUnlessAllowed) {
  const auto refused = [](const std::string& scale) {
    try {
      prepared(with("[blocks]", "[blocks]\n" + scale));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused("scale = { mass_kg = 20000 }"), "");
  EXPECT_TRUE(contains(refused("scale = { mass_kg = 2e5 }"),
                       "a block is no longer than a tenth of the terrain, which is 50 m across"));
  EXPECT_TRUE(contains(refused("scale = { mass_kg = 2e7 }"), "blocks are no heavier than 10000 t"));
  EXPECT_TRUE(contains(refused("scale = { mass_kg = 1e9 }"), "blocks are no longer than 20 m"));
  EXPECT_TRUE(
      contains(refused("allow_any_size = true\nscale = { mass_kg = 2e5 }"), "inside the ground"))
      << "only then is it placed";
}

}  // namespace
}  // namespace clast
