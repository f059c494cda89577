// Every number of a campaign against values that no study has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>
#include <tuple>

#include "core/random.hpp"
#include "tests/study/campaign_file.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// A key of a campaign: what of `kCampaign` to replace, by what, and where VALUE then stands.
struct Key {
  const char* name;
  const char* from;
  const char* to;
  const char* good;
  bool signed_number = false;  ///< a coordinate or component: 1e-300 is as good as 0
};

void PrintTo(const Key& key, std::ostream* out) { *out << key.name; }

std::string key_name(const testing::TestParamInfo<Key>& info) {
  std::string name = info.param.name;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

class CampaignNumber : public CampaignFile, public testing::WithParamInterface<Key> {
 protected:
  std::string refused(const std::string& value) const {
    std::string text = with(GetParam().from, GetParam().to);
    const std::size_t at = text.find("VALUE");
    return refusal(text.replace(at, 5, value));
  }
};

TEST_P(CampaignNumber, IsTakenWhereItMakesSense) { EXPECT_EQ(refused(GetParam().good), ""); }

TEST_P(CampaignNumber, IsRefusedWithKeyValueAndRangeWhereItDoesNot) {
  for (const char* value : {"1e308", "-1e308", "1e-300", "nan", "inf", "-inf"}) {
    if (GetParam().signed_number && std::string(value) == "1e-300") continue;
    const std::string message = refused(value);
    EXPECT_TRUE(message.starts_with("campaign.toml:")) << value << ": " << message;
    EXPECT_TRUE(contains(message, GetParam().name));
    EXPECT_TRUE(contains(message, value));
    EXPECT_TRUE(contains(message, "from ") && contains(message, " to ")) << value;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Keys, CampaignNumber,
    testing::Values(
        Key{"radius_m", "radius_m = 0.05", "radius_m = VALUE", "0.05"},
        Key{"resolution_m", "resolution_m = 0.5", "resolution_m = VALUE", "0.5"},
        Key{"percentile", "resolution_m = 0.5", "percentile = VALUE", "50"},
        Key{"outliers_m", "resolution_m = 0.5", "outliers_m = VALUE", "2"},
        Key{"fill_m", "resolution_m = 0.5", "fill_m = VALUE", "0"},
        Key{"crack_m", "resolution_m = 0.5", "crack_m = VALUE", "0"},
        Key{"spike_steepness", "resolution_m = 0.5", "spike_steepness = VALUE", "3"},
        Key{"tolerance_m", "resolution_m = 0.5", "tolerance_m = VALUE", "0.1"},
        Key{"border_distance_m", "resolution_m = 0.5", "border_distance_m = VALUE", "5"},
        Key{"energy_restitution", "energy_restitution = 0.01", "energy_restitution = VALUE", "0.3"},
        Key{"friction", "friction = 0.70", "friction = VALUE", "0"},
        Key{"rolling_friction", "rolling_friction = 0.35", "rolling_friction = VALUE", "0.1"},
        Key{"rolling_length_m", "rolling_friction = 0.35",
            "rolling_friction = 0.35\nrolling_length_m = VALUE", "0.1"},
        Key{"friction_min", "rolling_friction = 0.35",
            "rolling_friction = 0.35\nfriction_min = VALUE", "0.3"},
        Key{"slip_growth_per_m", "rolling_friction = 0.35",
            "rolling_friction = 0.35\nslip_growth_per_m = VALUE", "3"},
        Key{"slip_memory_s", "rolling_friction = 0.35",
            "rolling_friction = 0.35\nslip_memory_s = VALUE", "0.005"},
        Key{"scar_drag", "rolling_friction = 0.35", "rolling_friction = 0.35\nscar_drag = VALUE",
            "1.5"},
        Key{"soil_density_kg_m3", "rolling_friction = 0.35",
            "rolling_friction = 0.35\nsoil_density_kg_m3 = VALUE", "1800"},
        Key{"soil_memory_m", "rolling_friction = 0.35",
            "rolling_friction = 0.35\nsoil_memory_m = VALUE", "0.2"},
        Key{"height_m", "seed = 12", "height_m = VALUE", "1"},
        Key{"velocity_m_s", "[1, 0.5, 0]", "[0, VALUE, 0]", "5", true},
        Key{"angular_velocity_rad_s", "[0, 0, 2]", "[0, 0, VALUE]", "5", true},
        Key{"points", "\"points.xyz\"", "[[1, 2, VALUE]]", "5", true},
        Key{"line", "\"points.xyz\"", "{ line = [[1, 2, 3], [VALUE, 2, 3]], count = 3 }", "5",
            true},
        Key{"polygon", "points = \"points.xyz\"",
            "height_m = 1\npoints = { polygon = [[0, 0], [9, VALUE], [3, 3]], count = 3 }", "0",
            true},
        Key{"stiffness_n_m", "stiffness_n_m = 1e8", "stiffness_n_m = VALUE", "1e7"},
        Key{"tangential_stiffness_n_m", "stiffness_n_m = 1e8", "tangential_stiffness_n_m = VALUE",
            "1e7"},
        Key{"rolling_stiffness_n_m_rad", "stiffness_n_m = 1e8", "rolling_stiffness_n_m_rad = VALUE",
            "1e7"},
        Key{"time_step_s", "time_step_s = 2e-5", "time_step_s = VALUE", "1e-5"},
        Key{"from", "from = [25, -400]", "from = [VALUE, -400]", "30", true},
        Key{"to", "to = [25, -340]", "to = [25, VALUE]", "30", true},
        Key{"through", "from = [36, -400]\nto = [36, -340]",
            "through = [[36, -400], [VALUE, -340]]", "30", true},
        Key{"max_time_s", "max_time_s = 30", "max_time_s = VALUE", "60"},
        Key{"rest_energy_j_kg", "rest_energy_j_kg = 1e-4", "rest_energy_j_kg = VALUE", "2e-4"},
        Key{"rest_duration_s", "rest_duration_s = 0.25", "rest_duration_s = VALUE", "0.5"},
        Key{"gravity_m_s2", "gravity_m_s2 = 9.8", "gravity_m_s2 = VALUE", "1.62"},
        Key{"downslope", "[1, 0.1]", "[0, VALUE]", "1"},
        Key{"trajectory_interval_s", "trajectory_interval_s = 0", "trajectory_interval_s = VALUE",
            "0.1"}),
    key_name);

const char* const kSelect = "select = [\"B1\", \"B2\"]";

INSTANTIATE_TEST_SUITE_P(
    Blocks, CampaignNumber,
    testing::Values(Key{"mass_kg", kSelect, "scale = { mass_kg = VALUE }", "500"},
                    Key{"volume_m3", kSelect, "scale = { volume_m3 = VALUE }", "0.5"},
                    Key{"draw mass_kg", kSelect, "draw = { count = 3, mass_kg = VALUE }", "500"},
                    Key{"draw volume_m3", kSelect, "draw = { volume_m3 = VALUE }", "0.5"},
                    Key{"compact", kSelect,
                        "draw = { count = 3, shares = { compact = VALUE, elongated = 0.4 } }",
                        "0.6"}),
    key_name);

// Both numbers of each law, where the range is that of the key.
const char* const kMembers = "[ensemble]\nmembers = 2\n[ground.blue]\n";

class UncertainNumber : public CampaignFile,
                        public testing::WithParamInterface<std::tuple<const char*, const char*>> {};

TEST_P(UncertainNumber, IsRefusedWhereItMakesNoSense) {
  const auto& [law, good] = GetParam();
  const auto refused = [&](const std::string& value) {
    std::string numbers = law;
    numbers.replace(numbers.find("VALUE"), 5, value);
    std::string text = with("friction = 0.70", "friction = { " + numbers + " }");
    text.replace(text.find("[ground.blue]\n"), 14, kMembers);
    return refusal(text);
  };
  EXPECT_EQ(refused(good), "");
  for (const char* value : {"1e308", "-1e308", "1e-300", "nan", "inf"}) {
    const std::string message = refused(value);
    EXPECT_TRUE(contains(message, "friction") && contains(message, value) &&
                contains(message, "from "))
        << value;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, UncertainNumber,
                         testing::Values(std::tuple{"uniform = [VALUE, 0.8]", "0.5"},
                                         std::tuple{"uniform = [0.1, VALUE]", "0.5"},
                                         std::tuple{"normal = [VALUE, 0.1]", "0.5"},
                                         std::tuple{"normal = [0.5, VALUE]", "0.1"},
                                         std::tuple{"log_normal = [VALUE, 0.1]", "0.5"},
                                         std::tuple{"log_normal = [0.5, VALUE]", "0.3"}));

// Whatever passes is drawn in the end: the widest laws that are taken.
TEST(UncertainNumbers, TheWidestLawsDrawWithinTheirRange) {
  Random random(1);
  for (const Distribution& number :
       {Distribution{Distribution::Law::kNormal, 1e-6, 100.0, 1e-6, 100.0},
        Distribution{Distribution::Law::kNormal, 100.0, 100.0, 1e-6, 100.0},
        Distribution{Distribution::Law::kLogNormal, 1e-6, 5.0, 1e-6, 1.0},
        Distribution{Distribution::Law::kLogNormal, 1.0, 5.0, 1e-6, 1.0}}) {
    for (int i = 0; i < 1000; ++i) {
      const double value = number.draw(random);
      EXPECT_TRUE(value > number.low && value <= number.high);
    }
  }
}

TEST(UncertainNumbers, TheMeanIsThatOfTheDraws) {
  Random random(1);
  using Law = Distribution::Law;
  for (const Distribution& number :
       {Distribution{Law::kFixed, 3.0}, Distribution{Law::kUniform, 1.0, 4.0},
        Distribution{Law::kNormal, 2.0, 0.5}, Distribution{Law::kNormal, 2.0, 3.0, 1.0, 9.0},
        Distribution{Law::kLogNormal, 2.0, 0.7},
        Distribution{Law::kLogNormal, 2.0, 1.5, 1.0, 20.0}}) {
    constexpr int kDraws = 100000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kDraws; ++i) {
      const double value = number.draw(random);
      sum += value;
      squares += value * value;
    }
    const double mean = sum / kDraws;
    const double error = std::sqrt(std::max(0.0, squares / kDraws - mean * mean) / kDraws);
    EXPECT_NEAR(number.mean(), mean, 4.0 * error + 1e-9);
  }
}

TEST_F(CampaignFile, NumbersOfPointFilesHaveARangeToo) {
  for (const char* value : {"1e308", "-1e308", "nan", "inf"}) {
    write_text_file(folder_ / "points.xyz", "1 2 3\n1 2 " + std::string(value) + "\n");
    const std::string message = refusal(kCampaign);
    EXPECT_TRUE(contains(message, "points.xyz:2: " + std::string(value))) << message;
    EXPECT_TRUE(contains(message, "from -1e+08 to 1e+08 m"));
  }
}

TEST_F(CampaignFile, AZoneHasANameThatCanBeWritten) {
  for (const char* name : {"\"blue=gray\"", "\"blue\\u001b[31m\"", "\"\""}) {
    std::string text = with("[ground.blue]", "[ground." + std::string(name) + "]");
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with("campaign.toml:1")) << message;
    EXPECT_TRUE(contains(message, "a zone name must be one line without \"=\"")) << message;
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
  }
}

// Parsers and whoever walks over what they made need stack for each level.
TEST_F(CampaignFile, NestingHasALimitWithItsLine) {
  std::string dots = "a", quoted = "'a'", list(50000, '['), tables, header = "[a";
  for (int i = 0; i < 50000; ++i) {
    dots += ".a";
    quoted += " . \"a\"";
    tables += "{a=";
    header += ".a";
  }
  for (const std::string& deep : {dots + " = 1", quoted + " = 1", "x = " + list, "x = " + tables,
                                  "x = [ # ]\n" + list, header + "]", "[" + header + "]]"}) {
    for (const std::string& before :
         {std::string(), std::string("s = \"a # [[ \\\" \" # \"\n"),
          std::string("s = \"\"\"[[[\n\\\"\"\"\"\"\"\nt = '''[[\n''''\nu = 'c:\\'\n")}) {
      const std::string message = refusal(before + deep);
      const auto lines = std::count(before.begin(), before.end(), '\n') + 1;
      EXPECT_TRUE(contains(message, "no valid key is nested this deeply"))
          << before << deep.substr(0, 20);
      EXPECT_TRUE(message.starts_with("campaign.toml:" + std::to_string(lines)) ||
                  message.starts_with("campaign.toml:" + std::to_string(lines + 1)))
          << message;
    }
  }
  // What is inside texts and remarks is no nesting, and long lists are not deep.
  std::string many = "[[0.5, 1.5]";
  for (int i = 0; i < 200; ++i) many += ",\n[0.5, 1.5]";
  const std::string text =
      "# " + list + dots + "\nx = \"" + list + dots + "\"\ny = '" + list + "'\nz = " + many + "]\n";
  EXPECT_EQ(refusal(text).find("this deeply"), std::string::npos) << refusal(text).substr(0, 200);
}

}  // namespace
}  // namespace clast
