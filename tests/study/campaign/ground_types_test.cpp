// Usual ground parameters against the published tables they are from.
#include "study/campaign/ground_types.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/error.hpp"
#include "dem/contact/ground_parameters.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(GroundTypes, StartWithinTheirRangesAndAreValid) {
  for (const GroundType& type : typical_ground_types()) {
    for (const TypicalValue& number :
         {type.energy_restitution, type.friction, type.rolling_friction}) {
      EXPECT_LE(number.low, number.value) << type.name;
      EXPECT_LE(number.value, number.high) << type.name;
      EXPECT_LT(number.low, number.high) << type.name;
    }
    const GroundParameters parameters{type.energy_restitution.value, type.friction.value,
                                      type.rolling_friction.value};
    EXPECT_NO_THROW(parameters.check(type.name));
    EXPECT_FALSE(type.source.empty());
  }
}

// Table 2 of Garcia et al. (2022): mu and mu_R of its three grounds.
TEST(GroundTypes, TakeFrictionFromThePaper) {
  const auto expect = [](const char* name, double mu, double mu_r) {
    const GroundType& type = ground_type(name);
    EXPECT_EQ(type.friction.value, mu) << name;
    EXPECT_EQ(type.rolling_friction.value, mu_r) << name;
  };
  expect("rock", 0.30, 0.00);
  expect("talus", 0.70, 0.18);
  expect("scree", 0.70, 0.18);
  expect("soil medium", 0.70, 0.35);
}

// Mean R_n of the soil types of Rockyfor3D 5.2, and what is left of it at 10 m/s.
TEST(GroundTypes, TakeRestitutionFromRockyfor3D) {
  const std::map<std::string, double> r_n = {{"rock", 0.53},        {"talus", 0.38},
                                             {"scree", 0.33},       {"soil hard", 0.38},
                                             {"soil medium", 0.33}, {"soil soft", 0.23}};
  EXPECT_EQ(typical_ground_types().size(), r_n.size());
  for (const auto& [name, r] : r_n) {
    const TypicalValue& restitution = ground_type(name).energy_restitution;
    const double e_n = r / (1.0 + std::pow(10.0 / 9.0, 2.0));
    EXPECT_NEAR(restitution.value, e_n * e_n, 0.005) << name;
    EXPECT_NEAR(restitution.high, r * r, 0.005) << name;
    EXPECT_EQ(restitution.low, 0.01) << name;
  }
}

TEST(GroundTypes, AreFoundInNamesOfZones) {
  const auto found = [](const std::string& zone) -> std::string {
    const GroundType* type = find_ground_type(zone);
    return type ? type->name : "";
  };
  EXPECT_EQ(found("rock"), "rock");
  EXPECT_EQ(found("Rock walls"), "rock");
  EXPECT_EQ(found("upper_cliff-2"), "rock");
  EXPECT_EQ(found("hard rock"), "rock");
  EXPECT_EQ(found("TALUS"), "talus");
  EXPECT_EQ(found("éboulis"), "talus");
  EXPECT_EQ(found("fine scree"), "scree");
  EXPECT_EQ(found("soil"), "soil medium");
  EXPECT_EQ(found("soft soil"), "soil soft");
  EXPECT_EQ(found("meadow, hard"), "soil hard");
  EXPECT_EQ(found("soft"), "soil soft");
  EXPECT_EQ(found("road"), "soil hard");
  for (const char* silent :
       {"", "blue", "ground", "zone 3", "rockfall", "scree and meadow", "éé"}) {
    EXPECT_EQ(found(silent), "") << silent;
  }
}

TEST(GroundTypes, AnUnknownOneIsRefusedWithTheKnown) {
  const std::string text = refusal<InputError>([] { ground_type("lava"); });
  EXPECT_TRUE(contains(text, "lava") && contains(text, "soil medium")) << text;
}

}  // namespace
}  // namespace clast
