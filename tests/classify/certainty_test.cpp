#include "classify/certainty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

TEST(Certainty, NamesTheNearestLimit) {
  // q = 0.69 is 0.01 from 0.7; d = (100 - 85)/31 = 0.484 is farther from both of its limits.
  const ClassCertainty near_c = class_certainty("sneed-folk", {100, 85, 69}, 0.0);
  EXPECT_EQ(near_c.name, "CB");
  EXPECT_EQ(near_c.ratio, "S/L");
  EXPECT_EQ(near_c.limit, 0.7);
  EXPECT_NEAR(near_c.distance, 0.01, 1e-12);
  // d = 0.66.
  const ClassCertainty near_e = class_certainty("sneed-folk", {100, 60.4, 40}, 0.0);
  EXPECT_EQ(near_e.ratio, "(L-I)/(L-S)");
  EXPECT_NEAR(near_e.distance, 0.01, 1e-12);
  // Compact blocks have no second letter: d = 0 is near nothing.
  EXPECT_EQ(class_certainty("sneed-folk", {100, 100, 90}, 0.0).ratio, "S/L");
}

TEST(Certainty, ErrorOfTheAxesDecidesWhatIsPossible) {
  // q = 0.69: 69.5/99.5 = 0.698 and 70/99 = 0.707.
  const Axes axes{100, 85, 69};
  EXPECT_TRUE(class_certainty("sneed-folk", axes, 0.5).survives);
  const ClassCertainty certainty = class_certainty("sneed-folk", axes, 1.0);
  EXPECT_FALSE(certainty.survives);
  EXPECT_EQ(certainty.others, std::vector<std::string>{"C"});
  // s_c = 0.25: 126/99 - 1 = 0.273, 130/95 - 1 = 0.368.
  EXPECT_TRUE(class_certainty("garcia", {125, 100, 50}, 1.0).survives);
  EXPECT_FALSE(class_certainty("garcia", {125, 100, 50}, 5.0).survives);
}

// Five centimetres on a block of a decimetre allow nearly everything, but not a negative axis.
TEST(Certainty, AnErrorLargerThanTheAxesIsNoTrouble) {
  for (const std::string& scheme : scheme_names()) {
    const ClassCertainty certainty = class_certainty(scheme, {0.10, 0.06, 0.03}, 0.05);
    EXPECT_FALSE(certainty.survives) << scheme;
    EXPECT_FALSE(certainty.others.empty()) << scheme;
  }
}

// Second method: thousands of axes drawn within the error, and put in order.
TEST(Certainty, AgreesWithAxesDrawnWithinTheError) {
  Random random(11);
  int surviving = 0, lost = 0;
  for (int block = 0; block < 60; ++block) {
    const Axes axes = Axes::sorted(random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), 1.0);
    const double error = random.uniform(0.0, 0.05);
    for (const std::string& scheme : scheme_names()) {
      const ClassCertainty certainty = class_certainty(scheme, axes, error);
      bool all_same = true;
      for (int draw = 0; draw < 2000; ++draw) {
        // Every other draw at the ends of the ranges, where classes change first.
        const auto off = [&] {
          return draw % 2 ? random.uniform(-error, error)
                          : (random.below(2) ? 1.0 : -1.0) * error * random.uniform(0.99, 1.0);
        };
        const Axes drawn = Axes::sorted(axes.L + off(), axes.I + off(), axes.S + off());
        all_same = all_same && shape_class(scheme, drawn) == certainty.name;
      }
      if (certainty.survives) {
        EXPECT_TRUE(all_same) << scheme << " " << axes.L << " " << axes.I << " " << axes.S;
        ++surviving;
      } else if (!all_same) {
        ++lost;
      } else {
        // Nothing drawn, yet said to be possible: the corner that says so must be that close.
        EXPECT_FALSE(class_certainty(scheme, axes, error).survives);
        EXPECT_LT(certainty.distance, 0.2);
      }
    }
  }
  EXPECT_GT(surviving, 50);
  EXPECT_GT(lost, 50);
}

// Between two cells of "undetermined" lie other classes.
TEST(Certainty, UndeterminedOnBothSidesOfAClassDoesNotSurvive) {
  const ClassCertainty certainty = class_certainty("erdogan", {1.32, 1.0, 0.76}, 0.05);
  EXPECT_EQ(certainty.name, "undetermined");
  EXPECT_FALSE(certainty.survives);
}

TEST(Certainty, IsSaidInWords) {
  EXPECT_EQ(described(class_certainty("sneed-folk", {100, 85, 69}, 1.0)),
            "S/L 0.69 is 0.01 from 0.7; C possible");
  EXPECT_EQ(described(class_certainty("garcia", {100, 80, 60}, 0.1)), "s_c 0.25 is 0.05 from 0.3");
}

TEST(Certainty, AnErrorThatIsNoLengthIsRefused) {
  for (const double bad : {-0.01, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(class_certainty("zingg", {3, 2, 1}, bad), InputError);
  }
  EXPECT_THROW(class_certainty("none", {3, 2, 1}, 0.0), InputError);
}

}  // namespace
}  // namespace clast
