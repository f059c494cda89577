#include "classify/schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "core/error.hpp"

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

TEST(Schemes, EveryClassThatIsGivenIsListed) {
  for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
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
}

TEST(Schemes, AnUnknownOneIsRefusedWithTheKnown) {
  try {
    class_names("wentworth");
    FAIL() << "not refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const char* part : {"wentworth", "sneed-folk", "zingg", "garcia"}) {
      EXPECT_NE(message.find(part), std::string::npos) << part;
    }
  }
  EXPECT_THROW(shape_class("", {1, 1, 1}), InputError);
}

}  // namespace
}  // namespace clast
