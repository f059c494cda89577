#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <ostream>
#include <string_view>
#include <tuple>

#include "core/random.hpp"
#include "study/campaign/release_points.hpp"
#include "tests/study/campaign_file.hpp"

namespace clast {
namespace {

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
                "to, through, direction"},
        // missing
        Refused{"library = \"blocks.h5\"", "",
                "campaign.toml:1: [blocks]: library is missing; it must be a block library made by "
                "clast reconstruct"},
        Refused{"friction = 0.3\n", "",
                "campaign.toml:16: [ground.gray]: friction is missing; it must be mu, 0, or "
                "from 1e-06 to 100"},
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
                "campaign.toml:14: [ground.blue] friction = -1: must be 0, or from "
                "1e-06 to 100"},
        Refused{"energy_restitution = 0.01", "energy_restitution = 0",
                "campaign.toml:13: [ground.blue] energy_restitution = 0: must be from 1e-06 to 1"},
        Refused{"energy_restitution = 0.01", "energy_restitution = 1.01",
                "campaign.toml:13: [ground.blue] energy_restitution = 1.01: must be from 1e-06 to "
                "1"},
        Refused{"friction = 0.70", "friction = nan",
                "campaign.toml:14: [ground.blue] friction = nan: must be 0, or from "
                "1e-06 to 100"},
        Refused{"max_time_s = 30", "max_time_s = inf",
                "campaign.toml:44: [run] max_time_s = inf: must be from 0.001 to 100000 s"},
        Refused{"gravity_m_s2 = 9.8", "gravity_m_s2 = 0",
                "campaign.toml:47: [run] gravity_m_s2 = 0: must be from 0.01 to 1000 m/s^2"},
        Refused{"seed = 12", "seed = -12",
                "campaign.toml:26: [release] seed = -12: must be from 0 to 9223372036854775807"},
        Refused{"downslope = [1, 0.1]", "downslope = [0, 0]",
                "campaign.toml:48: [run] downslope = [0, 0]: must be a direction with a length "
                "from 1e-06 to 1e+06"},
        Refused{"velocity_m_s = [1, 0.5, 0]", "velocity_m_s = [1, nan, 0]",
                "campaign.toml:24: [release] velocity_m_s = [1, nan, 0]: must be three finite "
                "numbers, [x, y, z], each from -1000 to 1000 m/s"},
        Refused{"velocity_m_s = [1, 0.5, 0]", "velocity_m_s = [800, 0, 601]",
                "campaign.toml:24: [release] velocity_m_s = [800, 0, 601]: must be 1000 in size or "
                "less; check the units"},
        Refused{"velocity_m_s = [1, 0.5, 0]", "velocity_m_s = [0, 0, -1e200]",
                "campaign.toml:24: [release] velocity_m_s = [0, 0, -1e200]: must be three "
                "finite numbers, [x, y, z], each from -1000 to 1000 m/s"},
        Refused{"angular_velocity_rad_s = [0, 0, 2]", "angular_velocity_rad_s = [0, 9000, 9000]",
                "campaign.toml:25: [release] angular_velocity_rad_s = [0, 9000, 9000]: must be "
                "10000 in size or less; check the units"},
        Refused{"up = \"y\"", "up = \"x\"",
                "campaign.toml:8: [terrain] up = \"x\": must be \"z\", \"y\" or \"auto\""},
        Refused{"weights = \"overlap\"", "weights = \"equal\"",
                "campaign.toml:30: [contact] weights = \"equal\": must be \"patch\", \"overlap\", "
                "\"count\" or \"none\""},
        Refused{"law = \"spring-dashpot\"", "law = \"hertz\"",
                "campaign.toml:29: [contact] law = \"hertz\": must be \"energy-restitution\", "
                "\"spring-dashpot\" or \"elastoplastic\""},
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
        Refused{"to = [36, -340]", "through = [[36, -400], [36, -340]]",
                "campaign.toml:40: [[barrier]] from = [36, -400]: contradicts through, which "
                "already gives all points of the line; leave it out"},
        Refused{
            "from = [36, -400]\nto = [36, -340]", "through = [[36, -400]]",
            "campaign.toml:40: [[barrier]] through = [[36, -400]]: must be a list of two points "
            "or more, [[x, y], [x, y], ...]"},
        Refused{
            "from = [36, -400]\nto = [36, -340]", "through = [[36, -400], [36, -340], [36, -340]]",
            "campaign.toml:40: [[barrier]] through = [36, -340]: consecutive points must differ"},
        Refused{"from = [36, -400]\nto = [36, -340]", "through = [[36, -400], [36]]",
                "campaign.toml:40: [[barrier]] through = [36]: must be points [x, y]"},
        Refused{"from = [36, -400]\nto = [36, -340]", "through = [[0, 0], [4, 4], [4, 0], [0, 4]]",
                "campaign.toml:40: [[barrier]] through = [[0, 0], [4, 4], [4, 0], [0, 4]]: barrier "
                "EC12: segments 1 and 3 meet at (2, 2); a barrier must not cross, touch or retrace "
                "itself, apart from a ring, whose last point is its first: make two barriers of "
                "it"},
        Refused{"from = [36, -400]\nto = [36, -340]", "through = [[0, 0], [4, 0], [1, 0]]",
                "campaign.toml:40: [[barrier]] through = [[0, 0], [4, 0], [1, 0]]: barrier EC12: "
                "segments 1 and 2 meet at (1, 0); a barrier must not cross, touch or retrace "
                "itself, apart from a ring, whose last point is its first: make two barriers of "
                "it"},
        Refused{
            "friction = 0.70", "friction = 0,70",
            "campaign.toml:14: not TOML: Error while parsing key-value pair: expected a comment "
            "or whitespace, saw ','; numbers have a decimal point, as in 0.5"},
        Refused{"\"blocks.h5\"", "\"C:\\Data\\blocks.h5\"",
                "campaign.toml:2: not TOML: Error while parsing string: unknown escape sequence "
                "'\\D'; write paths with /, or between single quotes, as in 'C:\\blocks.h5'"},
        Refused{"\"blocks.h5\"", "blocks.h5",
                "campaign.toml:2: not TOML: Error while parsing value: could not determine value "
                "type; texts and paths need quotes, as in \"blocks.h5\""},
        Refused{"to = [36, -340]", "to = [36, -340]\ndirection = \"backward\"",
                "campaign.toml:42: [[barrier]] direction = \"backward\": \"backward\" is unknown; "
                "use either or forward"},
        Refused{"from = [36, -400]\nto = [36, -340]",
                "through = [[0, 0], [4, 0], [4, 4], [0, 0]]\ndirection = \"forward\"",
                "campaign.toml:41: [[barrier]] direction = \"forward\": is not for a ring, whose "
                "entries and exits both count"},
        Refused{
            "to = [36, -340]", "to = [36, -400]",
            "campaign.toml:41: [[barrier]] to = [36, -400]: must differ from the point in from"},
        Refused{
            "zones = [\"blue\", \"gray\"]", "zones = [\"blue\"]",
            "campaign.toml:7: [terrain] zones = [\"blue\"]: must name one zone per surface file "
            "(2), or one zone raster or GeoJSON file, or rules by slope and height"},
        Refused{"\"gray.stl\"]", "\"grey.stl\"]",
                "campaign.toml:6: [terrain] surface = \"grey.stl\": no such file: grey.stl"},
        Refused{"[ground.gray]", "[ground.blue]",
                "campaign.toml:16: not TOML: Error while parsing table header: cannot redefine "
                "existing table 'ground.blue'; correct this line"},
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
                "polygon has no area; give three or more corners that are not on one line"},
        Refused{"\"points.xyz\"", "{ line = [[1,2,3],[1,2,3]], count = 4 }",
                "campaign.toml:22: [release] points line = [[1,2,3],[1,2,3]]: all points of the "
                "line are the same, so it has no length"},
        Refused{"\"turns.txt\"", "\"grid45\"",
                "campaign.toml:23: [release] orientations = \"grid45\": must be \"grid-45\", a "
                "quaternion file, or { random = N, seed = S }; there is no file of this name"}));

// Values that a slip of the keyboard makes: they would fill memory, never end, or break tables.
INSTANTIATE_TEST_SUITE_P(
    Slips, CampaignRefusal,
    testing::Values(
        Refused{"trajectory_interval_s = 0", "trajectory_interval_s = 1e-9",
                "campaign.toml:49: [run] trajectory_interval_s = 1e-9: must be 0 (none is stored), "
                "or from 0.0001 to 100000 s"},
        Refused{"downslope = [1, 0.1]", "downslope = [1e200, 1e200]",
                "campaign.toml:48: [run] downslope = [1e200, 1e200]: must be two finite numbers, "
                "[x, y], each from -1e+06 to 1e+06"},
        Refused{"seed = 12", "seed = 12\nheight_m = 1e9",
                "campaign.toml:27: [release] height_m = 1e9: must be 0 (on the ground), or from "
                "1e-06 to 10000 m"},
        Refused{"name = \"EC12\"", "name = \"EC\\u000012\"",
                "campaign.toml:39: [[barrier]] name = \"EC\\u000012\": must be one line without "
                "control characters"},
        Refused{"name = \"EC12\"", "name = \"EC\\n12\"",
                "campaign.toml:39: [[barrier]] name = \"EC\\n12\": must be one line without "
                "control characters"},
        Refused{"select = [\"B1\", \"B2\"]", "select = [\"B\\t1\"]",
                "campaign.toml:3: [blocks] select = \"B\\t1\": must be one line without control "
                "characters"}));

// What blocks, groups and ensembles can ask for wrongly. Line 2 is where the library is named.
INSTANTIATE_TEST_SUITE_P(
    Content, CampaignRefusal,
    testing::Values(
        Refused{
            "select = [\"B1\", \"B2\"]", "scale = \"big\"",
            "campaign.toml:3: [blocks] scale = \"big\": must be \"equal-mass\", { mass_kg = M } "
            "or { volume_m3 = V }"},
        Refused{"select = [\"B1\", \"B2\"]", "scale = { mass_kg = -1 }",
                "campaign.toml:3: [blocks] scale mass_kg = -1: must be from 1e-09 to 1e+13 kg"},
        Refused{"select = [\"B1\", \"B2\"]", "draw = { count = 0 }",
                "campaign.toml:3: [blocks] draw count = 0: must be from 1 to 1000000"},
        Refused{"select = [\"B1\", \"B2\"]", "draw = { seed = 5 }",
                "campaign.toml:3: [blocks] draw: count is missing; it must be a whole number of "
                "blocks; or give volume_m3 instead"},
        Refused{"select = [\"B1\", \"B2\"]", "draw = { count = 5, volume_m3 = 2 }",
                "campaign.toml:3: [blocks] draw count = 5: contradicts volume_m3; keep one of "
                "the two"},
        Refused{"select = [\"B1\", \"B2\"]",
                "draw = { count = 5, shares = { compact = 0.5, elongated = 0.4 } }",
                "campaign.toml:3: [blocks] draw shares = { compact = 0.5, elongated = 0.4 }: the "
                "fractions must add up to 1, not 0.9"},
        Refused{"select = [\"B1\", \"B2\"]", "draw = { count = 5 }\nscale = \"equal-mass\"",
                "campaign.toml:4: [blocks] scale = \"equal-mass\": drawn blocks are scaled by "
                "mass_kg of draw; leave scale out"},
        Refused{"select = [\"B1\", \"B2\"]", "draw = { count = 5, mass_kg = { normal = [0, 5] } }",
                "campaign.toml:3: [blocks] draw mass_kg = { normal = [0, 5] }: its first number "
                "must be from 1e-09 to 1e+13 kg"},
        Refused{"friction = 0.70", "friction = { uniform = [0.8, 0.6] }",
                "campaign.toml:14: [ground.blue] friction = { uniform = [0.8, 0.6] }: the lower "
                "bound must come first"},
        Refused{"friction = 0.70", "friction = { normal = [0.8, 0] }",
                "campaign.toml:14: [ground.blue] friction = { normal = [0.8, 0] }: its second "
                "number, the spread, must be from 1e-06 to 100"},
        Refused{
            "friction = 0.70", "friction = { gamma = [0.8, 0] }",
            "campaign.toml:14: [ground.blue] friction = { gamma = [0.8, 0] }: must be a number, "
            "{ uniform = [low, high] }, { normal = [mean, std] } or { log_normal = [median, "
            "sigma] }"},
        Refused{"energy_restitution = 0.01", "energy_restitution = { uniform = [0.5, 1.5] }",
                "campaign.toml:13: [ground.blue] energy_restitution = { uniform = [0.5, 1.5] }: "
                "its second number must be from 1e-06 to 1"},
        Refused{"friction = 0.70", "friction = { uniform = [0.6, 0.8] }",
                "campaign.toml: ground parameters are uncertain; give the number of draws with "
                "[ensemble] members = N"},
        Refused{"[run]", "[ensemble]\nmembers = 3\n[run]",
                "campaign.toml:43: [ensemble]: no ground parameter is uncertain; write for example "
                "friction = { uniform = [0.5, 0.8] }"},
        Refused{"friction = 0.70\nrolling_friction = 0.35",
                "friction = { uniform = [0.6, 0.8] }\nrolling_friction = 0.35\n"
                "[ensemble]\nmembers = 3\ndesign = \"even\"",
                "campaign.toml:18: [ensemble] design = \"even\": must be \"random\" or "
                "\"sobol\""},
        Refused{"[run]", "[[block_group]]\nname = \"g\"\n[run]",
                "campaign.toml:43: [[block_group]]: select is missing; it must be ids, or { scheme "
                "= ..., class = ... }"},
        Refused{
            "[run]",
            "[[block_group]]\nname = \"g\"\nselect = [\"B1\"]\n"
            "ground.green = { friction = 1 }\n[run]",
            "campaign.toml:46: [[block_group]] ground.green = { friction = 1 }: the zone has no "
            "table [ground.green]"},
        Refused{"[run]",
                "[[block_group]]\nname = \"g\"\nselect = [\"B1\"]\nground.blue = {}\n[run]",
                "campaign.toml:43: [[block_group]]: ground names no parameter that "
                "differs; write for example ground.scree = { friction = 0.5 }"}));

TEST_F(CampaignFile, ReleaseSetsNeedNamesOfTheirOwn) {
  const std::string set = "points = \"points.xyz\"\norientations = \"turns.txt\"\n";
  std::string text = with("[release]\n" + set, "[[release]]\n" + set + "[[release]]\n" + set);
  EXPECT_EQ(refusal(text),
            "campaign.toml:21: [[release]]: name is missing; it must be a text in quotes, since "
            "there are several");
  text = with("[release]\n" + set,
              "[[release]]\nname = \"a\"\n" + set + "[[release]]\nname = \"a\"\n" + set);
  EXPECT_EQ(refusal(text),
            "campaign.toml:26: [[release]] name = \"a\": another release set has this name");
}

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
    if (i % 3 == 0) text.resize(random.uniform_index(text.size()));
    if (i % 3 == 1)
      text[random.uniform_index(text.size())] = static_cast<char>(random.uniform_index(256));
    if (i % 3 == 2) text.erase(random.uniform_index(text.size() - 20), random.uniform_index(20));
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
  EXPECT_EQ(refused_points("1 2 nan\n"),
            "points.xyz:1: nan is not a number from -1e+08 to 1e+08 m; a line must be three "
            "numbers, x y z");
  EXPECT_EQ(refused_points("# only this\n"),
            "points.xyz: has no line of numbers; each line must be three numbers, x y z");
  EXPECT_EQ(refused_points(""),
            "points.xyz: has no line of numbers; each line must be three numbers, x y z");
  EXPECT_EQ(refused_points("x y z\n# survey of May\n\n1;2;+3 # corner\r\n1;\t2;3e0\n"), "");
  EXPECT_EQ(refused_points("1;2;3\n1,2,3\n"),
            "points.xyz:2: 1 number; a line must be three numbers, x y z");
  EXPECT_EQ(refused_points("x,y,z\n1,5,2,5,3,5\n"),
            "points.xyz:2: 6 numbers; where commas are decimal signs, separate the columns by "
            "semicolons or tabs, or write decimal points; a line must be three numbers, x y z");
}

TEST_F(CampaignFile, QuaternionsAreNormalisedOrRefused) {
  const auto refused_turns = [&](const std::string& text) {
    write_text_file(folder_ / "turns.txt", text);
    return refusal(kCampaign);
  };
  EXPECT_EQ(refused_turns("1 0 0 0\n1 1 0 0\n"),
            "turns.txt:2: quaternion of length 1.41421; a rotation has length 1, written w x y z");
  EXPECT_EQ(refused_turns("0 0 0 0\n"),
            "turns.txt:1: quaternion of length 0; a rotation has length 1, written w x y z");
  EXPECT_EQ(refused_turns("1 0 0\n"),
            "turns.txt:1: 3 numbers; a line must be a quaternion, w x y z");
  // Columns by their names, in any order, and decimal commas.
  ASSERT_EQ(refused_turns("qx;qy;qz;qw\n0;0;0,6;0,8\n"), "");
  EXPECT_NEAR(read_orientation_table(folder_ / "turns.txt").at(0).w(), 0.8, 1e-15);
  EXPECT_NEAR(read_orientation_table(folder_ / "turns.txt").at(0).z(), 0.6, 1e-15);
  ASSERT_EQ(refused_turns("0.7075 0.7075 0 0\n"), "");
  const std::vector<Quat> read = read_orientation_table(folder_ / "turns.txt");
  EXPECT_NEAR(read[0].w(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(read[0].norm(), 1.0, 1e-15);
}

}  // namespace
}  // namespace clast
