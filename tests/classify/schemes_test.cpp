#include "classify/schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

struct Case {
  double L, I, S;
  const char* expected;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.L << " x " << c.I << " x " << c.S << " is " << c.expected;
}

class SneedFolk : public testing::TestWithParam<Case> {};

TEST_P(SneedFolk, ClassIsThePublishedOne) {
  const auto& [L, I, S, expected] = GetParam();
  EXPECT_EQ(sneed_folk_class({L, I, S}), expected);
  EXPECT_EQ(sneed_folk_class({L / 100.0, I / 100.0, S / 100.0}), expected);
  EXPECT_EQ(shape_class("sneed-folk", {L, I, S}), expected);
}

// Axes in cm on L = 100: S is 100 times S/L, I = 100 - d (100 - S) for a wanted (L-I)/(L-S) = d.
INSTANTIATE_TEST_SUITE_P(Fields, SneedFolk,
                         testing::Values(Case{100, 95, 80, "C"}, Case{100, 96, 60, "CP"},
                                         Case{100, 80, 60, "CB"}, Case{100, 64, 60, "CE"},
                                         Case{100, 94, 40, "P"}, Case{100, 70, 40, "B"},
                                         Case{100, 46, 40, "E"}, Case{100, 92, 20, "VP"},
                                         Case{100, 60, 20, "VB"}, Case{100, 28, 20, "VE"}));
INSTANTIATE_TEST_SUITE_P(
    LimitsFromBothSides, SneedFolk,
    testing::Values(
        // S/L = 0.7, 0.5 and 0.3 belong to the more compact side.
        Case{100, 85, 70, "C"}, Case{100, 85, 69.999, "CB"}, Case{100, 75, 50, "CB"},
        Case{100, 75, 49.999, "B"}, Case{100, 65, 30, "B"}, Case{100, 65, 29.999, "VB"},
        // d = 0.33 and 0.67 belong to bladed; I = 100 - d (100 - S).
        Case{100, 86.8, 60, "CB"}, Case{100, 86.801, 60, "CP"}, Case{100, 73.2, 60, "CB"},
        Case{100, 73.199, 60, "CE"}, Case{100, 80.2, 40, "B"}, Case{100, 80.201, 40, "P"},
        Case{100, 59.8, 40, "B"}, Case{100, 59.799, 40, "E"}, Case{100, 73.6, 20, "VB"},
        Case{100, 73.601, 20, "VP"}, Case{100, 46.4, 20, "VB"}, Case{100, 46.399, 20, "VE"}));
// Decimals whose binary quotients fall a hair short of the limit.
INSTANTIATE_TEST_SUITE_P(DecimalsOnALimit, SneedFolk,
                         testing::Values(Case{0.6, 0.5, 0.42, "C"}, Case{0.7, 0.6, 0.49, "C"},
                                         Case{1.1, 0.9, 0.77, "C"}, Case{1.1, 0.8, 0.55, "CB"},
                                         Case{0.9, 0.6, 0.27, "B"}, Case{2.1, 1.4, 0.63, "B"}));
INSTANTIATE_TEST_SUITE_P(Stones, SneedFolk,
                         testing::Values(Case{56, 49.5, 39, "CB"}, Case{46, 36, 13, "VP"},
                                         Case{2, 2, 2, "C"}, Case{1, 1, 0.1, "VP"},
                                         Case{1, 0.1, 0.1, "VE"}));

class Zingg : public testing::TestWithParam<Case> {};

TEST_P(Zingg, ClassIsThePublishedOne) {
  const auto& [L, I, S, expected] = GetParam();
  EXPECT_EQ(zingg_class({L, I, S}), expected);
  EXPECT_EQ(shape_class("zingg", {L, I, S}), expected);
}

INSTANTIATE_TEST_SUITE_P(Quadrants, Zingg,
                         testing::Values(Case{10, 9, 2, "disc"}, Case{10, 9, 8, "spheroid"},
                                         Case{10, 5, 2, "blade"}, Case{10, 4, 3.5, "rod"}));
// 2/3 belongs to the rounder side on both axes.
INSTANTIATE_TEST_SUITE_P(LimitsFromBothSides, Zingg,
                         testing::Values(Case{9, 6, 4, "spheroid"}, Case{9, 5.9999, 4, "rod"},
                                         Case{9, 6, 3.9999, "disc"}, Case{9, 5.9999, 3.9, "blade"},
                                         Case{0.9, 0.6, 0.4, "spheroid"},
                                         Case{0.3, 0.2, 0.1, "disc"}));

class Garcia : public testing::TestWithParam<Case> {};

TEST_P(Garcia, ClassIsThePublishedOne) {
  const auto& [L, I, S, expected] = GetParam();
  EXPECT_EQ(garcia_class({L, I, S}), expected);
  EXPECT_EQ(shape_class("garcia", {L, I, S}), expected);
}

// s_c = 0.3 itself is compact, also where 1.3/1.0 - 1 is a hair over 0.3 in binary.
INSTANTIATE_TEST_SUITE_P(Limit, Garcia,
                         testing::Values(Case{13, 10, 5, "compact"}, Case{1.3, 1.0, 0.2, "compact"},
                                         Case{0.91, 0.7, 0.2, "compact"},
                                         Case{0.78, 0.6, 0.2, "compact"},
                                         Case{13.001, 10, 5, "elongated"},
                                         Case{12.999, 10, 5, "compact"}, Case{1, 1, 0.1, "compact"},
                                         Case{2, 1, 1, "elongated"}));

class OtherScheme : public testing::TestWithParam<std::pair<const char*, Case>> {};

TEST_P(OtherScheme, ClassIsThePublishedOne) {
  const auto& [scheme, c] = GetParam();
  EXPECT_EQ(shape_class(scheme, {c.L, c.I, c.S}), c.expected);
  EXPECT_EQ(shape_class(scheme, {c.L / 1000.0, c.I / 1000.0, c.S / 1000.0}), c.expected);
}

INSTANTIATE_TEST_SUITE_P(Williams, OtherScheme,
                         testing::Values(std::pair{"williams", Case{4, 2, 1, "neither"}},
                                         std::pair{"williams", Case{4, 2.001, 1, "oblate"}},
                                         std::pair{"williams", Case{4, 1.999, 1, "prolate"}},
                                         std::pair{"williams", Case{0.9, 0.3, 0.1, "neither"}},
                                         std::pair{"williams", Case{3, 3, 3, "neither"}}));
// At the limit a ratio counts as more than near 1.
INSTANTIATE_TEST_SUITE_P(Erdogan, OtherScheme,
                         testing::Values(std::pair{"erdogan", Case{10, 9, 3, "platy"}},
                                         std::pair{"erdogan", Case{20, 9, 8, "elongated"}},
                                         std::pair{"erdogan", Case{10, 9, 8, "undetermined"}},
                                         std::pair{"erdogan", Case{20, 10, 5, "undetermined"}},
                                         std::pair{"erdogan", Case{13, 10, 9, "elongated"}},
                                         std::pair{"erdogan", Case{12.999, 10, 9, "undetermined"}},
                                         std::pair{"erdogan", Case{14, 13, 10, "platy"}},
                                         std::pair{"erdogan",
                                                   Case{14, 12.999, 10, "undetermined"}}));
INSTANTIATE_TEST_SUITE_P(
    BlottPye, OtherScheme,
    testing::Values(std::pair{"blott-pye", Case{100, 80, 64, "not elongate, not flat"}},
                    std::pair{"blott-pye", Case{100, 79.99, 64, "slightly elongate, not flat"}},
                    std::pair{"blott-pye", Case{100, 80, 63.99, "not elongate, slightly flat"}},
                    std::pair{"blott-pye", Case{100, 60, 36, "slightly elongate, slightly flat"}},
                    std::pair{"blott-pye", Case{100, 59.99, 23, "moderately elongate, very flat"}},
                    std::pair{"blott-pye",
                              Case{100, 40, 16, "moderately elongate, moderately flat"}},
                    std::pair{"blott-pye", Case{100, 39.99, 7, "very elongate, extremely flat"}},
                    std::pair{"blott-pye", Case{100, 20, 4, "very elongate, very flat"}},
                    std::pair{"blott-pye", Case{100, 19.99, 19, "extremely elongate, not flat"}}));
INSTANTIATE_TEST_SUITE_P(Aggregates, OtherScheme,
                         testing::Values(std::pair{"en-933-4", Case{3, 2, 1, "cubical"}},
                                         std::pair{"en-933-4", Case{0.3, 0.2, 0.1, "cubical"}},
                                         std::pair{"en-933-4", Case{3.001, 2, 1, "non-cubical"}},
                                         std::pair{"flakiness", Case{9, 8, 5, "not flaky"}},
                                         std::pair{"flakiness", Case{9, 8, 4.999, "flaky"}},
                                         std::pair{"flakiness", Case{9, 8.001, 5, "flaky"}}));

TEST(Schemes, ThirdsMoveTheSecondLetterOfSneedAndFolk) {
  const SchemeOptions thirds{.sneed_folk_thirds = true};
  // d = 0.332 and 0.668 on S/L = 0.4.
  EXPECT_EQ(sneed_folk_class({100, 80.08, 40}), "B");
  EXPECT_EQ(sneed_folk_class({100, 80.08, 40}, thirds), "P");
  EXPECT_EQ(sneed_folk_class({100, 59.92, 40}), "B");
  EXPECT_EQ(sneed_folk_class({100, 59.92, 40}, thirds), "E");
  EXPECT_EQ(shape_class("sneed-folk", {100, 80, 40}, thirds), "B");  // d = 1/3 itself
  EXPECT_EQ(shape_class("sneed-folk", {100, 60, 40}, thirds), "B");  // d = 2/3 itself
}

TEST(Schemes, TheLimitOfErdoganIsTheUsers) {
  EXPECT_EQ(erdogan_class({12, 10, 9}, {.erdogan_limit = 1.15}), "elongated");
  EXPECT_THROW(SchemeOptions{.erdogan_limit = 1.0}.check(), InputError);
  EXPECT_THROW(SchemeOptions{.erdogan_limit = std::nan("")}.check(), InputError);
  EXPECT_NO_THROW(SchemeOptions{.erdogan_limit = 1.01}.check());
}

// Whatever the ratio, stepping over a limit next to it is stepping into another class.
TEST(Schemes, EveryLimitBesideARatioChangesTheClass) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Axes axes = Axes::sorted(random.uniform(0.05, 1.0), random.uniform(0.05, 1.0), 1.0);
    for (const std::string& scheme : scheme_names()) {
      // Along L alone every ratio that holds L moves one way: walk until the class changes.
      std::vector<ClassifyingRatio> before = classifying_ratios(scheme, axes);
      for (double L = axes.L; L < 4.0 * axes.L; L *= 1.01) {
        const Axes longer{L, axes.I, axes.S};
        const std::vector<ClassifyingRatio> now = classifying_ratios(scheme, longer);
        bool crossed = now.size() != before.size();
        for (std::size_t r = 0; !crossed && r < now.size(); ++r) {
          for (const double limit : now[r].limits) {
            crossed = crossed || (now[r].value < limit) != (before[r].value < limit);
          }
        }
        const Axes shorter{std::max(axes.L, L / 1.01), axes.I, axes.S};
        EXPECT_EQ(shape_class(scheme, longer) != shape_class(scheme, shorter), crossed)
            << scheme << " " << L << " " << axes.I << " " << axes.S;
        before = now;
      }
    }
  }
}

TEST(Schemes, EveryClassThatIsGivenIsListed) {
  for (const std::string& scheme : scheme_names()) {
    const auto& names = class_names(scheme);
    for (double I = 0.05; I <= 1.0; I += 0.05) {
      for (double S = 0.05; S <= I; S += 0.05) {
        EXPECT_EQ(std::count(names.begin(), names.end(), shape_class(scheme, {1.0, I, S})), 1);
      }
    }
  }
  EXPECT_EQ(class_names("sneed-folk").size(), 10u);
  EXPECT_EQ(class_names("zingg").size(), 4u);
  EXPECT_EQ(class_names("garcia").size(), 2u);
  EXPECT_EQ(class_names("blott-pye").size(), 25u);
}

TEST(Schemes, AnUnknownOneIsRefusedWithTheKnown) {
  try {
    class_names("wentworth");
    FAIL() << "not refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("wentworth"), std::string::npos);
    for (const std::string& part : scheme_names()) {
      EXPECT_NE(message.find(part), std::string::npos) << part;
    }
  }
  EXPECT_THROW(shape_class("", {1, 1, 1}), InputError);
}

}  // namespace
}  // namespace clast
