// What the variance is due to, in words.
#include "report/text/effects_text.hpp"

#include <gtest/gtest.h>

namespace clast {
namespace {

VarianceFraction share(double estimate, double low, double high) {
  return {estimate, estimate, {low, high}};
}

DesignEffects effects() {
  DesignEffects file;
  file.factors = {{"form", 6}, {"orientation", 8}};
  file.outcomes = {
      {"runout",
       "m",
       20.0,
       5.0,
       {25.0, {share(0.22, 0.15, 0.294), share(0.31, 0.1, 0.5)}, share(0.47, 0.3, 0.6)}},
      {"passing N1",
       "",
       0.5,
       0.5,
       {0.25, {share(1.0, 0.9, 1.0), share(0.0, 0.0, 0.1)}, share(0.0, 0.0, 0.1)}}};
  return file;
}

TEST(EffectsText, SaysWhatEachFactorExplains) {
  const std::vector<std::string> sentences = describe_effects({effects()});
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(
      sentences[0],
      "Form explains 22 % (15 to 29) of the runout's variance, the orientation at release 31 % "
      "(10 to 50); 47 % (30 to 60) is due to their interaction.");
  EXPECT_TRUE(
      sentences[1].starts_with("Form explains 100 % (90 to 100) of the variance of passing "
                               "N1, the orientation at release 0 %"));
}

// Three blocks say next to nothing of the share of form.
TEST(EffectsText, GivesNoMiddleOfAnIntervalThatIsTooWide) {
  DesignEffects file = effects();
  file.outcomes[0].shares.factors[0] = share(0.09, 0.02, 0.82);
  const std::string text = describe_effects({file}).front();
  EXPECT_TRUE(text.starts_with(
      "Form explains between 2 and 82 % (too few data for a narrower range) of the "
      "runout's variance, the orientation at release 31 % (10 to 50)"))
      << text;
  EXPECT_EQ(text.find("9 %"), std::string::npos);
}

TEST(EffectsText, NamesTheFileWhereThereAreSeveralAndSaysWhyThereIsNothing) {
  DesignEffects second;
  second.file = 1;
  second.refusal_reason = "its 11 runs are not every combination once";
  const std::vector<std::string> sentences = describe_effects({effects(), second});
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_TRUE(sentences[0].starts_with("File 1: form explains"));
  EXPECT_EQ(sentences[2],
            "File 2: the variance cannot be divided among the factors: its 11 runs are not every "
            "combination once.");
}

TEST(EffectsText, SaysThatSharesAreEstimates) {
  DesignEffects file = effects();
  file.estimated = "11 runs are not every combination once";
  EXPECT_EQ(describe_effects({file}).front(),
            "The fractions are estimated with a mixed model with random factors: 11 runs "
            "are not every combination once.");
}

}  // namespace
}  // namespace clast
