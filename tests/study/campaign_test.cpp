#include "study/campaign.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string_view>
#include <tuple>

#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "study/release_points.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

// Every table, with the lines that the refusals below name.
const std::string kCampaign = R"([blocks]
library = "blocks.h5"
select = ["B1", "B2"]

[terrain]
surface = ["blue.stl", "gray.stl"]
zones = ["blue", "gray"]
up = "y"
radius_m = 0.05
resolution_m = 0.5

[ground.blue]
energy_restitution = 0.01
friction = 0.70
rolling_friction = 0.35
[ground.gray]
energy_restitution = 0.04
friction = 0.3
rolling_friction = 0

[release]
points = "points.xyz"
orientations = "turns.txt"
velocity_m_s = [1, 0.5, 0]
angular_velocity_rad_s = [0, 0, 2]
seed = 12

[contact]
law = "spring-dashpot"
weights = "overlap"
stiffness_n_m = 1e8
time_step_s = 2e-5

[[barrier]]
name = "EC11"
from = [25, -400]
to = [25, -340]
[[barrier]]
name = "EC12"
from = [36, -400]
to = [36, -340]

[run]
max_time_s = 30
rest_energy_j_kg = 1e-4
rest_duration_s = 0.25
gravity_m_s2 = 9.8
downslope = [1, 0.1]
trajectory_interval_s = 0
)";

class CampaignFile : public testing::Test {
 protected:
  CampaignFile() {
    for (const char* name : {"blocks.h5", "blue.stl", "gray.stl", "zones.geojson"}) {
      write_text_file(folder_ / name, "stand-in");
    }
    write_text_file(folder_ / "points.xyz", "1 2 3\n4 5 6\n");
    write_text_file(folder_ / "turns.txt", "q0 q1 q2 q3\n1 0 0 0\n0 1 0 0\n");
  }
  Campaign read(const std::string& text) const {
    write_text_file(folder_ / "campaign.toml", text);
    return read_campaign(folder_ / "campaign.toml");
  }
  // The message without the folder; empty when the campaign is accepted.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string prefix = folder_.path().string() + "/";
      for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
        message.erase(at, prefix.size());
      }
      return message;
    }
    return "";
  }
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = kCampaign;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) ADD_FAILURE() << "the campaign has no " << from;
    return text.replace(at, from.size(), to);
  }
  ScratchFolder folder_;
};

TEST_F(CampaignFile, EveryKeyArrives) {
  const Campaign campaign = read(kCampaign);
  EXPECT_EQ(campaign.text, kCampaign);
  EXPECT_EQ(campaign.sha256, sha256(kCampaign));
  EXPECT_EQ(campaign.blocks.library, folder_ / "blocks.h5");
  EXPECT_EQ(campaign.blocks.ids, (std::vector<std::string>{"B1", "B2"}));
  EXPECT_EQ(campaign.terrain.surface,
            (std::vector<std::filesystem::path>{folder_ / "blue.stl", folder_ / "gray.stl"}));
  EXPECT_EQ(campaign.terrain.zones, (std::vector<std::string>{"blue", "gray"}));
  EXPECT_EQ(campaign.terrain.up, "y");
  EXPECT_EQ(campaign.terrain_radius, 0.05);
  EXPECT_EQ(campaign.terrain.resolution, 0.5);
  ASSERT_EQ(campaign.ground.size(), 2u);
  EXPECT_EQ(campaign.ground.at("blue").rolling_friction, 0.35);
  EXPECT_EQ(campaign.ground.at("gray").energy_restitution, 0.04);
  EXPECT_EQ(campaign.ground.at("gray").friction, 0.3);
  EXPECT_EQ(campaign.release.velocity, Vec3(1, 0.5, 0));
  EXPECT_EQ(campaign.release.angular_velocity, Vec3(0, 0, 2));
  EXPECT_EQ(campaign.release.seed, 12u);
  EXPECT_FALSE(campaign.release.drop_height);
  EXPECT_FALSE(campaign.release.in_principal_frame);
  EXPECT_EQ(campaign.release.files.size(), 2u);
  EXPECT_EQ(campaign.weights, ContactWeights::kOverlap);
  EXPECT_EQ(name_of(campaign.stiffness.law), "spring-dashpot");
  EXPECT_EQ(campaign.stiffness.normal, 1e8);
  EXPECT_FALSE(campaign.stiffness.tangential);
  EXPECT_EQ(campaign.stiffness.time_step, 2e-5);
  ASSERT_EQ(campaign.barriers.size(), 2u);
  EXPECT_EQ(campaign.barriers[1].name, "EC12");
  EXPECT_EQ(campaign.barriers[1].from, Vec2(36, -400));
  EXPECT_EQ(campaign.max_time, 30.0);
  EXPECT_EQ(campaign.rest_energy, 1e-4);
  EXPECT_EQ(campaign.rest_duration, 0.25);
  EXPECT_EQ(campaign.gravity, 9.8);
  EXPECT_EQ(*campaign.downslope, Vec2(1, 0.1));
  EXPECT_EQ(campaign.trajectory_interval, 0.0);
}

TEST_F(CampaignFile, FilesWithYUpAreTurnedAndInlinePointsAreNot) {
  const Campaign campaign = read(kCampaign);
  EXPECT_EQ(campaign.release.points, (std::vector<Vec3>{{1, -3, 2}, {4, -6, 5}}));
  // A block that the file leaves as it is in its y-up world has its y axis up in ours, its z axis
  // along -y; a half turn about x turns both round.
  const Quat& kept = campaign.release.orientations[0];
  EXPECT_LT((kept * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-15);
  EXPECT_LT((kept * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((kept * Vec3::UnitZ() + Vec3::UnitY()).norm(), 1e-15);
  const Quat& turned = campaign.release.orientations[1];
  EXPECT_LT((turned * Vec3::UnitY() + Vec3::UnitZ()).norm(), 1e-15);

  const Campaign inline_points = read(with("\"points.xyz\"", "[[1, 2, 3]]"));
  EXPECT_EQ(inline_points.release.points, (std::vector<Vec3>{{1, 2, 3}}));
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
  EXPECT_TRUE(campaign.blocks.ids.empty());
  EXPECT_TRUE(campaign.blocks.scheme.empty());
  EXPECT_TRUE(campaign.terrain.zones.empty());
  EXPECT_EQ(campaign.terrain.up, "z");
  EXPECT_EQ(campaign.terrain_radius, 0.0);
  EXPECT_TRUE(campaign.release.in_principal_frame);
  EXPECT_EQ(campaign.release.orientations.size(), 64u);
  EXPECT_EQ(campaign.weights, ContactWeights::kPatch);
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
  EXPECT_EQ(campaign.blocks.scheme, "garcia");
  EXPECT_EQ(campaign.blocks.shape_class, "elongated");
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
  EXPECT_EQ(*campaign.release.drop_height, 1.5);
  EXPECT_EQ(campaign.release.points, (std::vector<Vec3>{{1, 2, 0}, {3, 4, 5}}));
}

TEST_F(CampaignFile, PointsOnALineAreEvenlySpaced) {
  const Campaign campaign =
      read(with("\"points.xyz\"", "{ line = [[0, 0, 5], [2, 0, 5], [2, 1, 5]], count = 4 }"));
  ASSERT_EQ(campaign.release.points.size(), 4u);
  const std::vector<Vec3> expected{{0, 0, 5}, {1, 0, 5}, {2, 0, 5}, {2, 1, 5}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((campaign.release.points[i] - expected[i]).norm(), 1e-15);
  }
}

TEST_F(CampaignFile, PointsInAPolygonLieInsideAndFollowTheSeed) {
  const auto points = [&](int seed) {
    return read(
               with("\"points.xyz\"", "{ polygon = [[0, 0], [4, 0], [4, 4]], count = 200, seed = " +
                                          std::to_string(seed) + " }\nheight_m = 1"))
        .release.points;
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
    return read(with("\"turns.txt\"", rule)).release.orientations;
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

struct Refused {
  const char* from;
  const char* to;
  const char* message;

  // "friction_0_70_becomes_friction_1", and "without_..." where nothing is left to name.
  std::string name() const {
    const std::string old_words = words(from), new_words = words(to);
    return new_words.empty() ? "without_" + old_words : old_words + "_becomes_" + new_words;
  }
  // Letters and digits, with one underscore for all that lies between.
  static std::string words(std::string_view text) {
    std::string result;
    for (const char c : text) {
      if (std::isalnum(static_cast<unsigned char>(c))) {
        result += c;
      } else if (!result.empty() && result.back() != '_') {
        result += '_';
      }
    }
    return result.substr(0, result.find_last_not_of('_') + 1);
  }
};

// Names the test in ctest; GoogleTest alone would print addresses, other ones in each build.
void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name(); }

class CampaignRefusal : public CampaignFile, public testing::WithParamInterface<Refused> {};

TEST_P(CampaignRefusal, NamesFileLineKeyValueAndWhatWasExpected) {
  EXPECT_EQ(refusal(with(GetParam().from, GetParam().to)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, CampaignRefusal,
    testing::Values(
        // unknown
        Refused{"friction = 0.70", "frictoin = 0.70",
                "campaign.toml:14: [ground.blue] frictoin = 0.70: unknown key; did you mean "
                "friction?"},
        Refused{"max_time_s = 30", "max_time = 30",
                "campaign.toml:44: [run] max_time = 30: unknown key; did you mean max_time_s?"},
        Refused{"[contact]", "[contacts]",
                "campaign.toml:28: [contacts]: unknown table; did you mean contact?"},
        Refused{"name = \"EC12\"", "name = \"EC12\"\ncolour = 1",
                "campaign.toml:40: [[barrier]] colour = 1: unknown key; known here are name, from, "
                "to"},
        // missing
        Refused{"library = \"blocks.h5\"", "",
                "campaign.toml:1: [blocks]: library is missing; it must be a block library made by "
                "clast reconstruct"},
        Refused{"friction = 0.3\n", "",
                "campaign.toml:16: [ground.gray]: friction is missing; it must be mu, zero or "
                "more"},
        Refused{"points = \"points.xyz\"", "",
                "campaign.toml:21: [release]: points is missing; it must be a point file, a list "
                "[[x, y, z], ...], { line = [...], count = N } or { polygon = [...], count = N }"},
        Refused{"from = [36, -400]\n", "",
                "campaign.toml:38: [[barrier]]: from is missing; it must be two numbers, [x, y]"},
        // wrong type
        Refused{"friction = 0.70", "friction = \"0.70\"",
                "campaign.toml:14: [ground.blue] friction = \"0.70\": must be a number"},
        Refused{"library = \"blocks.h5\"", "library = 5",
                "campaign.toml:2: [blocks] library = 5: must be a text in quotes"},
        Refused{"select = [\"B1\", \"B2\"]", "select = [\"B1\", 2]",
                "campaign.toml:3: [blocks] select = 2: each element must be a text in quotes, not "
                "empty"},
        Refused{"seed = 12", "seed = 1.5",
                "campaign.toml:26: [release] seed = 1.5: must be a whole number"},
        Refused{"max_time_s = 30", "max_time_s = true",
                "campaign.toml:44: [run] max_time_s = true: must be a number"},
        Refused{"max_time_s = 30", "max_time_s = 2026-01-01",
                "campaign.toml:44: [run] max_time_s = 2026-01-01: must be a number"},
        Refused{"from = [25, -400]", "from = 25",
                "campaign.toml:36: [[barrier]] from = 25: must be two finite numbers, [x, y]"},
        // out of range
        Refused{"friction = 0.70", "friction = -1",
                "campaign.toml:14: [ground.blue] friction = -1: must be zero or more"},
        Refused{"energy_restitution = 0.01", "energy_restitution = 0",
                "campaign.toml:13: [ground.blue] energy_restitution = 0: must be more than zero "
                "and at most 1"},
        Refused{"energy_restitution = 0.01", "energy_restitution = 1.01",
                "campaign.toml:13: [ground.blue] energy_restitution = 1.01: must be more than zero "
                "and at most 1"},
        Refused{"friction = 0.70", "friction = nan",
                "campaign.toml:14: [ground.blue] friction = nan: must be zero or more"},
        Refused{"max_time_s = 30", "max_time_s = inf",
                "campaign.toml:44: [run] max_time_s = inf: must be more than zero"},
        Refused{"gravity_m_s2 = 9.8", "gravity_m_s2 = 0",
                "campaign.toml:47: [run] gravity_m_s2 = 0: must be more than zero"},
        Refused{"seed = 12", "seed = -12",
                "campaign.toml:26: [release] seed = -12: must be from 0 to 9223372036854775807"},
        Refused{"downslope = [1, 0.1]", "downslope = [0, 0]",
                "campaign.toml:48: [run] downslope = [0, 0]: must point somewhere"},
        Refused{"velocity_m_s = [1, 0.5, 0]", "velocity_m_s = [1, nan, 0]",
                "campaign.toml:24: [release] velocity_m_s = [1, nan, 0]: must be three finite "
                "numbers, [x, y, z]"},
        Refused{"up = \"y\"", "up = \"x\"",
                "campaign.toml:8: [terrain] up = \"x\": must be \"z\" or \"y\""},
        Refused{"weights = \"overlap\"", "weights = \"equal\"",
                "campaign.toml:30: [contact] weights = \"equal\": must be \"patch\", \"overlap\", "
                "\"count\" or \"none\""},
        Refused{"law = \"spring-dashpot\"", "law = \"hertz\"",
                "campaign.toml:29: [contact] law = \"hertz\": must be \"energy-restitution\" or "
                "\"spring-dashpot\""},
        Refused{"stiffness_n_m = 1e8", "stiffness = 1e8",
                "campaign.toml:31: [contact] stiffness = 1e8: must be \"auto\"; a value is "
                "written stiffness_n_m"}));

INSTANTIATE_TEST_SUITE_P(
    Meaning, CampaignRefusal,
    testing::Values(
        Refused{"stiffness_n_m = 1e8", "stiffness_n_m = 1e8\nstiffness = \"auto\"",
                "campaign.toml:31: [contact] stiffness_n_m = 1e8: contradicts stiffness = "
                "\"auto\"; keep one of the two"},
        Refused{"select = [\"B1\", \"B2\"]", "select = [\"B1\",\n\"B1\"]",
                "campaign.toml:4: [blocks] select = \"B1\": the block is named twice"},
        Refused{"name = \"EC12\"", "name = \"EC11\"",
                "campaign.toml:39: [[barrier]] name = \"EC11\": another barrier has this name"},
        Refused{"to = [36, -340]", "to = [36, -400]",
                "campaign.toml:41: [[barrier]] to = [36, -400]: must differ from from"},
        Refused{
            "zones = [\"blue\", \"gray\"]", "zones = [\"blue\"]",
            "campaign.toml:7: [terrain] zones = [\"blue\"]: must name one zone per surface file "
            "(2), or one zone raster or GeoJSON file"},
        Refused{"\"gray.stl\"]", "\"grey.stl\"]",
                "campaign.toml:6: [terrain] surface = \"grey.stl\": no such file: grey.stl"},
        Refused{"[ground.gray]", "[ground.blue]",
                "campaign.toml:16: not TOML: Error while parsing table header: cannot redefine "
                "existing table 'ground.blue'"},
        Refused{
            "\"turns.txt\"", "\"grid-45\"\nframe = \"source\"",
            "campaign.toml:24: [release] frame = \"source\": the orientations of grid-45 turn the "
            "principal frame; leave frame out"},
        Refused{"\"turns.txt\"", "{ random = 0 }",
                "campaign.toml:23: [release] orientations random = 0: must be from 1 to 1000000"},
        Refused{"\"points.xyz\"", "[[1, 2]]",
                "campaign.toml:22: [release] points = [1, 2]: must be points of three finite "
                "numbers, [x, y, z]; [x, y] needs height_m"},
        Refused{"\"points.xyz\"", "[]",
                "campaign.toml:22: [release] points = []: must be a list of at least 1 points"},
        Refused{"\"points.xyz\"", "{ polygon = [[0,0],[1,0],[1,1]], count = 4 }",
                "campaign.toml:22: [release] points: a polygon gives plan positions and needs "
                "height_m"},
        Refused{"\"points.xyz\"", "{ polygon = [[0,0],[1,1],[2,2]], count = 4 }\nheight_m = 1",
                "campaign.toml:22: [release] points polygon = [[0,0],[1,1],[2,2]]: the "
                "polygon has no area"}));

TEST_F(CampaignFile, WhatIsNotTomlIsRefusedWithItsLine) {
  for (const auto& [from, to, line] : {std::tuple{"friction = 0.70", "friction = = 0.70", 14},
                                       {"[run]", "[run", 43},
                                       {"\"EC11\"", "\"EC11", 35},
                                       {"[blocks]", "\xff\xfe", 1}}) {
    const std::string message = refusal(with(from, to));
    const std::string begin = "campaign.toml:" + std::to_string(line) + ": not TOML: ";
    EXPECT_EQ(message.substr(0, begin.size()), begin) << message;
  }
}

TEST_F(CampaignFile, DamagedTextIsReadOrRefusedButNeverMore) {
  Random random(20);
  std::size_t refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text = kCampaign;
    if (i % 3 == 0) text.resize(random.below(text.size()));
    if (i % 3 == 1) text[random.below(text.size())] = static_cast<char>(random.below(256));
    if (i % 3 == 2) text.erase(random.below(text.size() - 20), random.below(20));
    if (!refusal(text).empty()) ++refused;
  }
  EXPECT_GT(refused, 150u);
  EXPECT_NE(refusal("x = " + std::string(100000, '[')), "");
}

TEST_F(CampaignFile, MissingTablesAreNamed) {
  EXPECT_EQ(refusal("[terrain]\nsurface = \"blue.stl\"\n"),
            "campaign.toml: the table [blocks] is missing");
  EXPECT_EQ(refusal("[blocks]\nlibrary = \"blocks.h5\"\n[terrain]\nsurface = \"blue.stl\"\n"),
            "campaign.toml: no ground: write one table [ground.NAME] per zone");
  EXPECT_EQ(refusal(""), "campaign.toml: the table [blocks] is missing");
  EXPECT_EQ(refusal("blocks = 3\n"), "campaign.toml:1: [blocks] = 3: must be a table");
  EXPECT_THROW(read_campaign(folder_ / "none.toml"), InputError);
}

TEST_F(CampaignFile, BadLinesOfPointFilesAreNamed) {
  const auto refused_points = [&](const std::string& text) {
    write_text_file(folder_ / "points.xyz", text);
    return refusal(kCampaign);
  };
  EXPECT_EQ(refused_points("1 2 3\n1 2\n"),
            "points.xyz:2: 2 numbers; a line must be three numbers, x y z");
  EXPECT_EQ(refused_points("1 2 3\n4 five 6\n"),
            "points.xyz:2: \"five\" is not a number; a line must be three numbers, x y z");
  EXPECT_EQ(refused_points("1 2 3\nx y z\n"),
            "points.xyz:2: \"x\" is not a number; a line must be three numbers, x y z");
  EXPECT_EQ(refused_points("1 2 nan\n"), "points.xyz:1: nan is not a finite number");
  EXPECT_EQ(refused_points("# only this\n"),
            "points.xyz: holds no line with numbers; each line must be three numbers, x y z");
  EXPECT_EQ(refused_points(""),
            "points.xyz: holds no line with numbers; each line must be three numbers, x y z");
  EXPECT_EQ(refused_points("x y z\n# survey of May\n\n1;2;+3 # corner\r\n1,\t2 3e0\n"), "");
}

TEST_F(CampaignFile, QuaternionsAreNormalisedOrRefused) {
  const auto refused_turns = [&](const std::string& text) {
    write_text_file(folder_ / "turns.txt", text);
    return refusal(kCampaign);
  };
  EXPECT_EQ(refused_turns("1 0 0 0\n1 1 0 0\n"),
            "turns.txt:2: quaternion of length 1.414214; a rotation has length 1, written w x y z");
  EXPECT_EQ(refused_turns("0 0 0 0\n"),
            "turns.txt:1: quaternion of length 0.000000; a rotation has length 1, written w x y z");
  EXPECT_EQ(refused_turns("1 0 0\n"),
            "turns.txt:1: 3 numbers; a line must be a quaternion, w x y z");
  ASSERT_EQ(refused_turns("0.7075 0.7075 0 0\n"), "");
  const std::vector<Quat> read = read_orientations(folder_ / "turns.txt");
  EXPECT_NEAR(read[0].w(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(read[0].norm(), 1.0, 1e-15);
}

TEST(Grid45, HasSixtyFourRotationsInTheOrderOfTheDefinition) {
  const std::vector<Quat> grid = grid_45_orientations();
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
