#include "study/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/files/digest.hpp"
#include "study/campaign/release_points.hpp"
#include "tests/study/campaign_file.hpp"

namespace clast {
namespace {

TEST_F(CampaignFile, EveryKeyArrives) {
  const Campaign campaign = read(kCampaign);
  EXPECT_EQ(campaign.text, kCampaign);
  EXPECT_EQ(campaign.sha256, sha256(kCampaign));
  EXPECT_EQ(campaign.blocks.library, folder_ / "blocks.h5");
  EXPECT_EQ(campaign.blocks.filter.ids, (std::vector<std::string>{"B1", "B2"}));
  EXPECT_EQ(campaign.terrain.surface,
            (std::vector<std::filesystem::path>{folder_ / "blue.stl", folder_ / "gray.stl"}));
  EXPECT_EQ(campaign.terrain.zones, (std::vector<std::string>{"blue", "gray"}));
  EXPECT_EQ(campaign.terrain.up, "y");
  EXPECT_EQ(campaign.terrain_radius, 0.05);
  EXPECT_EQ(campaign.terrain.resolution, 0.5);
  ASSERT_EQ(campaign.ground.size(), 2u);
  EXPECT_EQ(campaign.ground.at("blue").rolling_friction->first, 0.35);
  EXPECT_EQ(campaign.ground.at("gray").energy_restitution->first, 0.04);
  EXPECT_EQ(campaign.ground.at("gray").friction->first, 0.3);
  EXPECT_EQ(campaign.releases[0].velocity, Vec3(1, 0.5, 0));
  EXPECT_EQ(campaign.releases[0].angular_velocity, Vec3(0, 0, 2));
  EXPECT_EQ(campaign.releases[0].seed, 12u);
  EXPECT_FALSE(campaign.releases[0].drop_height);
  EXPECT_FALSE(campaign.releases[0].in_principal_frame);
  EXPECT_EQ(campaign.releases[0].files.size(), 2u);
  EXPECT_EQ(campaign.weighting, ContactWeighting::kOverlap);
  EXPECT_EQ(name_of(campaign.stiffness.law), "spring-dashpot");
  EXPECT_EQ(campaign.stiffness.normal, 1e8);
  EXPECT_FALSE(campaign.stiffness.tangential);
  EXPECT_EQ(campaign.stiffness.time_step, 2e-5);
  ASSERT_EQ(campaign.barriers.size(), 2u);
  EXPECT_EQ(campaign.barriers[1].name, "EC12");
  EXPECT_EQ(campaign.barriers[1].vertices.front(), Vec2(36, -400));
  EXPECT_EQ(campaign.max_time, 30.0);
  EXPECT_EQ(campaign.rest_energy, 1e-4);
  EXPECT_EQ(campaign.rest_duration, 0.25);
  EXPECT_EQ(campaign.gravity, 9.8);
  EXPECT_EQ(*campaign.downslope, Vec2(1, 0.1));
  EXPECT_EQ(campaign.trajectory_interval, 0.0);
}

TEST_F(CampaignFile, FilesWithYUpAreTurnedAndInlinePointsAreNot) {
  const Campaign campaign = read(kCampaign);
  EXPECT_EQ(campaign.releases[0].points, (std::vector<Vec3>{{1, -3, 2}, {4, -6, 5}}));
  // A block that the file leaves as it is in its y-up world has its y axis up in ours, its z axis
  // along -y; a half turn about x turns both round.
  const Quat& kept = campaign.releases[0].orientations[0];
  EXPECT_LT((kept * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-15);
  EXPECT_LT((kept * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((kept * Vec3::UnitZ() + Vec3::UnitY()).norm(), 1e-15);
  const Quat& turned = campaign.releases[0].orientations[1];
  EXPECT_LT((turned * Vec3::UnitY() + Vec3::UnitZ()).norm(), 1e-15);

  const Campaign inline_points = read(with("\"points.xyz\"", "[[1, 2, 3]]"));
  EXPECT_EQ(inline_points.releases[0].points, (std::vector<Vec3>{{1, 2, 3}}));
}

TEST_F(CampaignFile, AbsentTablesAndKeysHaveTheirDefaults) {
  const Campaign campaign = read(R"(
[blocks]
library = "blocks.h5"
[terrain]
surface = "blue.stl"
[ground.ground]
energy_restitution = 1
friction = 0
rolling_friction = 0
[release]
points = [[1, 2, 3]]
orientations = "grid-45"
)");
  EXPECT_TRUE(campaign.blocks.filter.ids.empty());
  EXPECT_TRUE(campaign.blocks.filter.scheme.empty());
  EXPECT_TRUE(campaign.terrain.zones.empty());
  EXPECT_EQ(campaign.terrain.up, "auto");
  EXPECT_EQ(campaign.terrain_radius, 0.0);
  EXPECT_TRUE(campaign.releases[0].in_principal_frame);
  EXPECT_EQ(campaign.releases[0].orientations.size(), 64u);
  EXPECT_EQ(campaign.weighting, ContactWeighting::kPatch);
  EXPECT_EQ(name_of(campaign.stiffness.law), "energy-restitution");
  EXPECT_FALSE(campaign.stiffness.normal);
  EXPECT_EQ(campaign.max_time, 60.0);
  EXPECT_EQ(campaign.rest_energy, 2e-4);
  EXPECT_EQ(campaign.rest_duration, 0.5);
  EXPECT_EQ(campaign.gravity, 9.81);
  EXPECT_FALSE(campaign.downslope);
  EXPECT_EQ(campaign.trajectory_interval, 0.1);
}

TEST_F(CampaignFile, BlocksAreSelectedByClass) {
  const Campaign campaign =
      read(with("[\"B1\", \"B2\"]", "{ scheme = \"garcia\", class = \"elongated\" }"));
  EXPECT_EQ(campaign.blocks.filter.scheme, "garcia");
  EXPECT_EQ(campaign.blocks.filter.shape_class, "elongated");
  EXPECT_EQ(refusal(with("[\"B1\", \"B2\"]", "{ scheme = \"garcia\", class = \"blade\" }")),
            "campaign.toml:3: [blocks] select class = \"blade\": must be \"compact\" or "
            "\"elongated\"");
}

TEST_F(CampaignFile, ZoneFileIsFound) {
  const Campaign campaign = read(with("[\"blue\", \"gray\"]", "\"zones.geojson\""));
  EXPECT_EQ(campaign.terrain.zones,
            (std::vector<std::string>{(folder_ / "zones.geojson").string()}));
}

TEST_F(CampaignFile, ZoneRasterWithClassNamesIsFound) {
  write_text_file(folder_ / "zones.ASC", "stand-in");
  const std::vector<std::string> expected = {(folder_ / "zones.ASC").string() + ":1=blue,2=gray"};
  for (const char* zones : {"[\"zones.ASC:1=blue,2=gray\"]", "\"zones.ASC:2=gray,1=blue\"",
                            "[\"zones.ASC:1=blue\", \"2=gray\"]"}) {
    EXPECT_EQ(read(with("[\"blue\", \"gray\"]", zones)).terrain.zones, expected) << zones;
  }
  EXPECT_EQ(refusal(with("[\"blue\", \"gray\"]", "\"no.bil:1=blue\"")),
            "campaign.toml:7: [terrain] zones = \"no.bil:1=blue\": no such file: no.bil");
  EXPECT_EQ(refusal(with("[\"blue\", \"gray\"]", "\"zones.ASC:one=blue\"")),
            "campaign.toml:7: [terrain] zones = \"zones.ASC:one=blue\": zones: \"one=blue\" is not "
            "CLASS=NAME; write for example zones.asc:1=blue,2=gray");
}

TEST_F(CampaignFile, PointsWithADropHeightMayBePlanPositions) {
  std::string text = with("\"points.xyz\"", "[[1, 2], [3, 4, 5]]\nheight_m = 1.5");
  const Campaign campaign = read(text);
  EXPECT_EQ(*campaign.releases[0].drop_height, 1.5);
  EXPECT_EQ(campaign.releases[0].points, (std::vector<Vec3>{{1, 2, 0}, {3, 4, 5}}));
}

TEST_F(CampaignFile, PointsOnALineAreEvenlySpaced) {
  const Campaign campaign =
      read(with("\"points.xyz\"", "{ line = [[0, 0, 5], [2, 0, 5], [2, 1, 5]], count = 4 }"));
  ASSERT_EQ(campaign.releases[0].points.size(), 4u);
  const std::vector<Vec3> expected{{0, 0, 5}, {1, 0, 5}, {2, 0, 5}, {2, 1, 5}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((campaign.releases[0].points[i] - expected[i]).norm(), 1e-15);
  }
}

TEST_F(CampaignFile, PointsInAPolygonLieInsideAndFollowTheSeed) {
  const auto points = [&](int seed) {
    return read(
               with("\"points.xyz\"", "{ polygon = [[0, 0], [4, 0], [4, 4]], count = 200, seed = " +
                                          std::to_string(seed) + " }\nheight_m = 1"))
        .releases[0]
        .points;
  };
  const std::vector<Vec3> first = points(1);
  ASSERT_EQ(first.size(), 200u);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : first) {
    EXPECT_TRUE(point.y() > 0 && point.y() < point.x() && point.x() < 4);
    mean += point / 200.0;
  }
  // Centroid of the triangle; standard error sqrt(16/18/200), five of them.
  EXPECT_NEAR(mean.x(), 8.0 / 3.0, 0.34);
  EXPECT_NEAR(mean.y(), 4.0 / 3.0, 0.34);
  EXPECT_EQ(points(1), first);
  EXPECT_NE(points(2), first);
}

TEST_F(CampaignFile, RandomOrientationsFollowTheirSeed) {
  const auto orientations = [&](const std::string& rule) {
    return read(with("\"turns.txt\"", rule)).releases[0].orientations;
  };
  const auto first = orientations("{ random = 5, seed = 12 }");
  ASSERT_EQ(first.size(), 5u);
  const auto of_release_seed = orientations("{ random = 5 }");
  const auto other = orientations("{ random = 5, seed = 13 }");
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(first[i].coeffs(), of_release_seed[i].coeffs());
    EXPECT_NE(first[i].coeffs(), other[i].coeffs());
  }
}

TEST_F(CampaignFile, DataFolderIsTakenFromTheEnvironment) {
  ::setenv("CLAST_DATA", folder_.path().c_str(), 1);
  const Campaign campaign = read(with("\"blocks.h5\"", "\"${CLAST_DATA}/gray.stl\""));
  EXPECT_EQ(campaign.blocks.library, folder_ / "gray.stl");
  ::unsetenv("CLAST_DATA");
  const std::string message = refusal(with("\"blocks.h5\"", "\"${CLAST_DATA}/no/such.h5\""));
  const auto folder = (std::filesystem::current_path() / "../shared/data").lexically_normal();
  EXPECT_NE(message.find(": no such file: " + (folder / "no/such.h5").string()), std::string::npos)
      << message;
  EXPECT_EQ(
      refusal(with("\"blocks.h5\"", "\"${HOME}/b.h5\"")),
      "campaign.toml:2: [blocks] library = \"${HOME}/b.h5\": only ${CLAST_DATA} is replaced in "
      "paths");
}

TEST(Grid45, HasSixtyFourRotationsInTheOrderOfTheDefinition) {
  const std::vector<Quat> grid = orientations_in_45_degree_grid();
  ASSERT_EQ(grid.size(), 64u);
  EXPECT_EQ(grid[0].coeffs(), Quat::Identity().coeffs());
  // c fastest: the second turns 45 degrees about z, the fifth about y, the 17th about x.
  const double c = std::cos(kPi / 8), s = std::sin(kPi / 8);
  const auto expect = [&](std::size_t i, double w, double x, double y, double z) {
    EXPECT_LT((grid[i].coeffs() - Quat(w, x, y, z).coeffs()).norm(), 1e-15) << i;
  };
  expect(1, c, 0, 0, s);
  expect(4, c, 0, s, 0);
  expect(16, c, s, 0, 0);
  // The last, all three 135 degrees: with C = cos 67.5 and S = sin 67.5 by hand,
  // qz qy = (C^2, -S^2, C S, C S), times qx = (C, S, 0, 0).
  const double C = std::cos(3 * kPi / 8), S = std::sin(3 * kPi / 8);
  expect(63, C * C * C + S * S * S, C * C * S - S * S * C, C * C * S + C * S * S,
         C * C * S - C * S * S);
}

}  // namespace
}  // namespace clast
