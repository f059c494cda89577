#include "classify/certainty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

TEST(Certainty, NamesTheNearestLimit) {
  // q = 0.69 is 0.01 from 0.7; d = (100 - 85)/31 = 0.484 is farther from both of its limits.
  const ClassCertainty near_c = assess_class_certainty("sneed-folk", {100, 85, 69}, 0.0);
  EXPECT_EQ(near_c.name, "CB");
  EXPECT_EQ(near_c.nearest_ratio, "S/L");
  EXPECT_EQ(near_c.nearest_limit, 0.7);
  EXPECT_NEAR(near_c.distance, 0.01, 1e-12);
  // d = 0.66.
  const ClassCertainty near_e = assess_class_certainty("sneed-folk", {100, 60.4, 40}, 0.0);
  EXPECT_EQ(near_e.nearest_ratio, "(L-I)/(L-S)");
  EXPECT_NEAR(near_e.distance, 0.01, 1e-12);
  // Compact blocks have no second letter: d = 0 is near nothing.
  EXPECT_EQ(assess_class_certainty("sneed-folk", {100, 100, 90}, 0.0).nearest_ratio, "S/L");
}

TEST(Certainty, ErrorOfTheAxesDecidesWhatIsPossible) {
  // q = 0.69: 69.5/99.5 = 0.698 and 70/99 = 0.707.
  const Axes axes{100, 85, 69};
  EXPECT_TRUE(assess_class_certainty("sneed-folk", axes, 0.5).is_certain);
  const ClassCertainty certainty = assess_class_certainty("sneed-folk", axes, 1.0);
  EXPECT_FALSE(certainty.is_certain);
  EXPECT_EQ(certainty.other_possible_classes, std::vector<std::string>{"C"});
  // s_c = 0.25: 126/99 - 1 = 0.273, 130/95 - 1 = 0.368.
  EXPECT_TRUE(assess_class_certainty("garcia", {125, 100, 50}, 1.0).is_certain);
  EXPECT_FALSE(assess_class_certainty("garcia", {125, 100, 50}, 5.0).is_certain);
}

// Five centimetres on a block of a decimetre allow nearly everything, but not a negative axis.
TEST(Certainty, AnErrorLargerThanTheAxesIsNoTrouble) {
  for (const std::string& scheme : scheme_names()) {
    const ClassCertainty certainty = assess_class_certainty(scheme, {0.10, 0.06, 0.03}, 0.05);
    EXPECT_FALSE(certainty.is_certain) << scheme;
    EXPECT_FALSE(certainty.other_possible_classes.empty()) << scheme;
  }
}

/// Classes of all axes on a grid of `steps` values over the range of each axis, put in order.
std::set<std::string> scanned_classes(const std::string& scheme, const Axes& axes, double error,
                                      int steps) {
  std::set<std::string> found;
  const auto at = [&](double axis, int k) { return axis + error * (2.0 * k / (steps - 1) - 1.0); };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      for (int k = 0; k < steps; ++k) {
        found.insert(
            shape_class(scheme, Axes::sorted(at(axes.L, i), at(axes.I, j), at(axes.S, k))));
      }
    }
  }
  return found;
}

std::set<std::string> said_classes(const ClassCertainty& certainty) {
  std::set<std::string> said(certainty.other_possible_classes.begin(),
                             certainty.other_possible_classes.end());
  said.insert(certainty.name);
  return said;
}

// Blocks of the Authume quarry whose corners of the error miss a class that lies between them.
TEST(Certainty, ClassesBetweenTheExtremesArePossibleToo) {
  const auto others = [](const Axes& axes) {
    return assess_class_certainty("sneed-folk", axes, kTapeError).other_possible_classes;
  };
  const auto holds = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  // (0.95, 0.75, 0.53): q = 0.558, d = 0.476; (0.93, 0.65, 0.46): q = 0.495, d = 0.596;
  // (0.97, 0.65, 0.48): q = 0.495, d = 0.653; (1.0, 0.65, 0.49): q = 0.49, d = 0.686, which is E.
  EXPECT_TRUE(holds(others({0.95, 0.7, 0.5}), "E"));
  // (0.6, 0.55, 0.41): q = 0.683, d = 0.263, which is CP.
  EXPECT_TRUE(holds(others({0.6, 0.5, 0.45}), "CP"));
}

// Second method, and from both sides. A scan of the axes must find no class that is not said; and
// each class said must be found by a scan, if need be a fine one: ratios don't change when all axes
// grow by one factor, so every reachable ratio is reached with one axis at its largest.
TEST(Certainty, IsCompleteAndHoldsNothingElse) {
  Random random(11);
  std::size_t compared = 0, more_than_one = 0;
  for (int block = 0; block < 40; ++block) {
    const Axes axes = Axes::sorted(random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), 1.0);
    const double error = random.uniform(0.0, 0.08);
    for (const std::string& scheme : scheme_names()) {
      const ClassCertainty certainty = assess_class_certainty(scheme, axes, error);
      std::set<std::string> said = said_classes(certainty);
      EXPECT_EQ(certainty.is_certain, said.size() == 1);
      if (scheme == "williams") {
        // A line between the other two: a grid does not meet it.
        EXPECT_EQ(said.erase("neither"), said.size() == 3 ? 1u : 0u);
      }
      for (const std::string& name : scanned_classes(scheme, axes, error, 11)) {
        EXPECT_TRUE(said.count(name)) << scheme << " " << name << " " << axes.I << " " << axes.S;
        said.erase(name);
        ++compared;
      }
      more_than_one += !certainty.is_certain;
      constexpr int kFine = 500;
      for (int face = 0; face < 3 && !said.empty(); ++face) {
        for (int i = 0; i <= kFine; ++i) {
          for (int k = 0; k <= kFine; ++k) {
            const double one = error * (2.0 * i / kFine - 1.0),
                         other = error * (2.0 * k / kFine - 1.0);
            said.erase(shape_class(scheme, Axes::sorted(axes.L + (face == 0 ? error : one),
                                                        axes.I + (face == 1   ? error
                                                                  : face == 0 ? one
                                                                              : other),
                                                        axes.S + (face == 2 ? error : other))));
          }
        }
      }
      EXPECT_TRUE(said.empty()) << scheme << " " << *said.begin() << " is not possible for 1, "
                                << axes.I << ", " << axes.S << " +- " << error;
    }
  }
  EXPECT_GT(compared, 500u);
  EXPECT_GT(more_than_one, 100u);
}

// 1.05/0.35 is the limit of 3 itself, where a block is still cubical: nothing else is possible.
TEST(Certainty, AClassThatOnlyTouchesItsLimitSurvives) {
  const ClassCertainty certainty = assess_class_certainty("en-933-4", {1.0, 0.7, 0.4}, 0.05);
  EXPECT_EQ(certainty.name, "cubical");
  EXPECT_TRUE(certainty.is_certain);
  EXPECT_TRUE(certainty.other_possible_classes.empty());
  // A hair more and 1.0501/0.3499 is above it.
  EXPECT_FALSE(assess_class_certainty("en-933-4", {1.0, 0.7, 0.4}, 0.0501).is_certain);
}

// I^2 = L S between oblate and prolate is a class of its own, if one without an area.
TEST(Certainty, TheLineOfWilliamsIsPossibleWhereItIsCrossed) {
  const std::vector<std::string> others =
      assess_class_certainty("williams", {1.0, 0.72, 0.5}, 0.05).other_possible_classes;
  EXPECT_EQ(others, (std::vector<std::string>{"neither", "prolate"}));
  // 0.84^2 > 1.01 * 0.51: far from the line.
  EXPECT_TRUE(assess_class_certainty("williams", {1.0, 0.85, 0.5}, 0.01).is_certain);
}

TEST(Certainty, HoldsForAxesOfAnySize) {
  for (const double size : {1e-9, 1e-3, 1e3, 1e9}) {
    EXPECT_EQ(assess_class_certainty("sneed-folk", {size, 0.85 * size, 0.69 * size}, 0.01 * size)
                  .other_possible_classes,
              std::vector<std::string>{"C"});
  }
}

// Between two cells of "undetermined" lie other classes.
TEST(Certainty, UndeterminedOnBothSidesOfAClassDoesNotSurvive) {
  const ClassCertainty certainty = assess_class_certainty("erdogan", {1.32, 1.0, 0.76}, 0.05);
  EXPECT_EQ(certainty.name, "undetermined");
  EXPECT_FALSE(certainty.is_certain);
}

TEST(Certainty, IsSaidInWords) {
  EXPECT_EQ(describe_certainty(assess_class_certainty("sneed-folk", {100, 85, 69}, 1.0)),
            "S/L 0.69 is 0.01 from 0.7; C possible");
  EXPECT_EQ(describe_certainty(assess_class_certainty("garcia", {100, 80, 60}, 0.1)),
            "s_c 0.25 is 0.05 from 0.3");
}

TEST(Certainty, AnErrorThatIsNoLengthIsRefused) {
  for (const double bad : {-0.01, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(assess_class_certainty("zingg", {3, 2, 1}, bad), InputError);
  }
  EXPECT_THROW(assess_class_certainty("none", {3, 2, 1}, 0.0), InputError);
}

}  // namespace
}  // namespace clast
