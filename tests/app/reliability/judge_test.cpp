/// The judge of the reliability trial on answers that are known to be right or wrong.
#include "tests/app/reliability/judge.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "classify/schemes.hpp"
#include "tests/app/reliability/table.hpp"

namespace clast::reliability {
namespace {

using Json = nlohmann::json;

/// A block of 1 x 0.7 x 0.5 m: class CB of Sneed & Folk, far from its limits.
const Expected kBlockColour = {{0.2, {1.0, 0.7, 0.5}}, {}};

Json block(double volume, const Axes& axes) {
  return {{"volume_m3", volume},
          {"box_m", {axes.L, axes.I, axes.S}},
          {"sneed_folk", sneed_folk_class(axes)},
          {"zingg", zingg_class(axes)},
          {"shape", garcia_class(axes)},
          {"warnings", Json::array()}};
}

/// The same with a range, and the class of its own axes as the only possible one.
Json bracketed(Json block, double low, double high, const Axes& lower, const Axes& upper) {
  block["unseen"] = {{"volume_lower_m3", low},
                     {"volume_upper_m3", high},
                     {"axes_lower_m", {lower.L, lower.I, lower.S}},
                     {"axes_upper_m", {upper.L, upper.I, upper.S}},
                     {"sneed_folk", {block["sneed_folk"]}},
                     {"zingg", {block["zingg"]}},
                     {"shape", {block["shape"]}}};
  return block;
}

Given given(const Json& block) {
  return given_by({0, Json{{"blocks", {block}}, {"failed", Json::array()}}.dump(), ""});
}

Outcome outcome_of(const Json& block) { return judge(given(block), {kBlockColour}).outcome; }

TEST(ReliabilityJudge, ValuesWithinTheToleranceAreRight) {
  EXPECT_EQ(outcome_of(block(0.2, {1.0, 0.7, 0.5})), Outcome::kRight);
  EXPECT_EQ(outcome_of(block(0.2019, {1.014, 0.69, 0.507})), Outcome::kRight);
  EXPECT_EQ(outcome_of(block(0.1981, {0.986, 0.71, 0.493})), Outcome::kRight);
}

TEST(ReliabilityJudge, AValueOffWithoutARangeIsWrong) {
  EXPECT_EQ(outcome_of(block(0.2021, {1.0, 0.7, 0.5})), Outcome::kWrong);
  EXPECT_EQ(outcome_of(block(0.1979, {1.0, 0.7, 0.5})), Outcome::kWrong);
  EXPECT_EQ(outcome_of(block(0.2, {1.016, 0.7, 0.5})), Outcome::kWrong);
  EXPECT_EQ(outcome_of(block(0.2, {1.0, 0.689, 0.5})), Outcome::kWrong);
  EXPECT_EQ(outcome_of(block(0.2, {1.0, 0.7, 0.508})), Outcome::kWrong);
}

TEST(ReliabilityJudge, AClassThatIsNotThatOfTheAxesIsWrong) {
  Json other = block(0.2, {1.0, 0.7, 0.5});
  other["sneed_folk"] = "VE";
  EXPECT_EQ(outcome_of(other), Outcome::kWrong);
}

TEST(ReliabilityJudge, AnotherClassIsRightWhereALimitIsWithinTheTolerance) {
  const Expected near_limit = {{0.2, {1.0, 0.9, 0.699}}, {}};  // S/L = 0.7 is a limit
  const Json compact = block(0.2, {1.0, 0.9, 0.701});
  ASSERT_NE(compact["sneed_folk"], sneed_folk_class(near_limit.truth.axes));
  EXPECT_EQ(judge(given(compact), {near_limit}).outcome, Outcome::kRight);
}

TEST(ReliabilityJudge, ARangeThatHoldsTheTruthIsHonest) {
  const Json off = block(0.21, {1.0, 0.7, 0.52});
  const Json honest = bracketed(off, 0.19, 0.23, {1.0, 0.7, 0.49}, {1.0, 0.7, 0.55});
  const Verdict verdict = judge(given(honest), {kBlockColour});
  EXPECT_EQ(verdict.outcome, Outcome::kBracketed) << verdict.why;
  EXPECT_EQ(verdict.missed, "");
  EXPECT_NEAR(verdict.width.value(), 0.2, 1e-12);
}

TEST(ReliabilityJudge, ARangeThatMissesTheTruthIsWrong) {
  const Json off = block(0.21, {1.0, 0.7, 0.52});
  EXPECT_EQ(outcome_of(bracketed(off, 0.201, 0.23, {1.0, 0.7, 0.49}, {1.0, 0.7, 0.55})),
            Outcome::kWrong);
  EXPECT_EQ(outcome_of(bracketed(off, 0.19, 0.23, {1.0, 0.7, 0.51}, {1.0, 0.7, 0.55})),
            Outcome::kWrong);
  Json other_class =
      bracketed(block(0.21, {1.0, 0.7, 0.31}), 0.19, 0.23, {1.0, 0.7, 0.3}, {1.0, 0.7, 0.55});
  EXPECT_EQ(outcome_of(other_class), Outcome::kWrong);
  other_class["unseen"]["sneed_folk"].push_back(sneed_folk_class(kBlockColour.truth.axes));
  other_class["unseen"]["zingg"].push_back(zingg_class(kBlockColour.truth.axes));
  other_class["unseen"]["shape"].push_back(garcia_class(kBlockColour.truth.axes));
  EXPECT_EQ(outcome_of(other_class), Outcome::kBracketed);
}

TEST(ReliabilityJudge, ARangeThatMissesIsCountedBesideAValueThatIsRight) {
  const Json right =
      bracketed(block(0.2015, {1.0, 0.7, 0.5}), 0.201, 0.23, {1.0, 0.7, 0.5}, {1.0, 0.7, 0.5});
  const Verdict verdict = judge(given(right), {kBlockColour});
  EXPECT_EQ(verdict.outcome, Outcome::kRight);
  EXPECT_NE(verdict.missed, "");
}

TEST(ReliabilityJudge, AnUpperBoundThatIsSaidToBeUnknownHoldsAnything) {
  Json open = bracketed(block(0.1, {0.7, 0.6, 0.5}), 0.09, 0.0, {0.7, 0.6, 0.5}, {1, 1, 1});
  for (const auto& [scheme, key] : std::map<std::string, std::string>{
           {"sneed-folk", "sneed_folk"}, {"zingg", "zingg"}, {"garcia", "shape"}}) {
    open["unseen"][key].push_back(shape_class(scheme, kBlockColour.truth.axes));
  }
  open["unseen"]["volume_upper_m3"] = nullptr;
  open["unseen"]["axes_upper_m"] = nullptr;
  const Verdict verdict = judge(given(open), {kBlockColour});
  EXPECT_EQ(verdict.outcome, Outcome::kBracketed) << verdict.why;
  EXPECT_FALSE(verdict.width);
}

TEST(ReliabilityJudge, OneOfSeveralAnswersIsEnoughWhereItIsSaid) {
  Expected copy = {{0.21, {1.02, 0.71, 0.51}}, {}, {"copy"}};
  Json larger = block(0.21, {1.02, 0.71, 0.51});
  EXPECT_EQ(judge(given(larger), {kBlockColour, copy}).outcome, Outcome::kWrong);
  larger["warnings"] = {"a copy of the surface was dropped"};
  EXPECT_EQ(judge(given(larger), {kBlockColour, copy}).outcome, Outcome::kRight);
}

TEST(ReliabilityJudge, OnlyAPlainRefusalIsOne) {
  const auto outcome = [](int code, const std::string& message) {
    return judge(given_by({code, "", message}), {kBlockColour}).outcome;
  };
  EXPECT_EQ(outcome(1, "clast: scan.ply: no block"), Outcome::kRefused);
  EXPECT_EQ(outcome(1, "clast: unexpected failure, please report it: vector"), Outcome::kWrong);
  EXPECT_EQ(outcome(1, ""), Outcome::kWrong);
  EXPECT_EQ(outcome(2, "clast: no such option"), Outcome::kWrong);
  EXPECT_EQ(outcome(124, ""), Outcome::kWrong);
  EXPECT_EQ(outcome(139, ""), Outcome::kWrong);
}

TEST(ReliabilityTable, CountsWhatWasJudged) {
  const Judged right{"a", "1 %", "", {Outcome::kRight, "", {}, ""}};
  const Judged wide{"a", "2 %", "", {Outcome::kBracketed, "", 0.3, "L"}};
  const Judged wrong{"b", "", "", {Outcome::kWrong, "", 0.5, "I"}};
  const std::string kinds = markdown_table({right, wide, wrong}, false);
  EXPECT_NE(kinds.find("| a | 2 | 1 | 1 | 0 | 0 | 30.0 % | 1 |"), std::string::npos) << kinds;
  EXPECT_NE(kinds.find("| b | 1 | 0 | 0 | 0 | 1 | - | 1 |"), std::string::npos) << kinds;
  EXPECT_NE(kinds.find("| all | 3 | 1 | 1 | 0 | 1 | 30.0 % | 2 |"), std::string::npos) << kinds;
  const std::string levels = markdown_table({right, wide, wrong}, true);
  EXPECT_NE(levels.find("| a | 2 % | 1 | 0 | 1 | 0 | 0 | 30.0 % | 1 |"), std::string::npos);
}

}  // namespace
}  // namespace clast::reliability
