// Differences of groups whose values come in crossed clusters, and how many it takes to find one.
#include "core/statistics/crossed_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Blocks of two halves, all from all points, several runs each.
struct CrossedStudy {
  std::uint32_t units = 12, points = 6, each = 4;
  double difference = 0.0;
  double of_unit = 1.0;   ///< standard deviations
  double of_point = 3.0;  ///< the same for both halves
  double of_half = 0.7;   ///< of the difference, from point to point
  double of_run = 2.0;
  bool unbalanced = false;  ///< a third of the runs are missing

  /// Of the difference, by the model.
  double standard_error() const {
    const double u = units, p = points, k = each;
    return std::sqrt(4.0 / u * of_unit * of_unit + of_half * of_half / p +
                     4.0 / (u * p * k) * of_run * of_run);
  }
};

CrossedSample crossed_sample(const CrossedStudy& study, Random& random) {
  CrossedSample sample;
  std::vector<double> of_point, of_half;
  for (std::uint32_t p = 0; p < study.points; ++p) {
    of_point.push_back(study.of_point * random.normal());
    of_half.push_back(study.of_half * random.normal());
  }
  for (std::uint32_t u = 0; u < study.units; ++u) {
    const bool high = u % 2 == 1;
    const double of_unit = study.of_unit * random.normal() + (high ? study.difference : 0.0);
    for (std::uint32_t p = 0; p < study.points; ++p) {
      for (std::uint32_t k = 0; k < study.each; ++k) {
        const double value =
            of_unit + of_point[p] + (high ? of_half[p] : 0.0) + study.of_run * random.normal();
        if (study.unbalanced && random.uniform_index(3) == 0) continue;
        sample.values.push_back(value);
        sample.in_second_group.push_back(high);
        sample.units.push_back(u);
        sample.points.push_back(p);
        sample.strata.push_back(p);
      }
    }
  }
  return sample;
}

struct Shares {
  double found = 0.0;       ///< p below 0.05
  double equivalent = 0.0;  ///< within the margin at 5 %
  double held = 0.0;        ///< intervals that hold the true difference
};

Shares shares_of(const CrossedStudy& study, double margin) {
  constexpr int kStudies = 2000;
  Random random(3);
  Shares shares;
  for (int i = 0; i < kStudies; ++i) {
    const auto found = crossed_difference(crossed_sample(study, random));
    if (!found) continue;
    shares.found += found->p_value < 0.05 ? 1.0 / kStudies : 0.0;
    shares.equivalent += equivalence_p_value(*found, margin) < 0.05 ? 1.0 / kStudies : 0.0;
    shares.held +=
        found->interval->low <= study.difference && study.difference <= found->interval->high
            ? 1.0 / kStudies
            : 0.0;
  }
  return shares;
}

// Two blocks in each half from two points, one run each, by hand: means 1.5 and 4.5.
TEST(CrossedDifference, IsTheDifferenceOfTheMeans) {
  const CrossedSample sample{{1, 3, 2, 4, 4, 6, 5, 7},
                             {false, false, false, false, true, true, true, true},
                             {0, 0, 1, 1, 2, 2, 3, 3},
                             {0, 1, 0, 1, 0, 1, 0, 1},
                             {0, 1, 0, 1, 0, 1, 0, 1}};
  const auto found = crossed_difference(sample);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->estimate, 3.0, 1e-12);
  EXPECT_NEAR(found->scatter, 0.5, 1e-12) << "blocks are half a metre off, points do not count";
  EXPECT_NEAR(found->design_effect, 4.0, 1e-9)
      << "each block's two runs are one, and two means were fitted to four blocks";
  EXPECT_NEAR(found->degrees_of_freedom, 2.0, 1e-9) << "points make no difference";
}

// The level of 5 %, over 2,000 studies without a difference (known to 0.5 %), and that of the
// equivalence test where the true difference is the margin. Few points make both careful.
TEST(CrossedDifference, TestsHoldTheirLevels) {
  const CrossedStudy null;
  EXPECT_NEAR(shares_of(null, 1.0).found, 0.05, 0.015);
  EXPECT_GE(shares_of(null, 1.0).held, 0.93);
  CrossedStudy unbalanced;
  unbalanced.unbalanced = true;
  EXPECT_NEAR(shares_of(unbalanced, 1.0).found, 0.05, 0.02);
  CrossedStudy at_margin;
  at_margin.units = 40;
  at_margin.difference = 2.0;
  EXPECT_NEAR(shares_of(at_margin, 2.0).equivalent, 0.05, 0.02);
  CrossedStudy nothing = at_margin;
  nothing.difference = 0.0;
  EXPECT_GT(shares_of(nothing, 2.0).equivalent, 0.8) << "no difference is called none";
}

TEST(CrossedDifference, PowerIsAsPredicted) {
  for (const double difference : {1.0, 1.5, 2.5}) {
    CrossedStudy study;
    study.units = 24;
    study.points = 12;
    study.difference = difference;
    // Degrees of freedom as a study of the kind has them.
    Random random(9);
    double degrees_of_freedom = 0.0;
    for (int i = 0; i < 50; ++i)
      degrees_of_freedom += crossed_difference(crossed_sample(study, random))->degrees_of_freedom;
    const double predicted =
        test_power(difference, study.standard_error(), degrees_of_freedom / 50.0);
    EXPECT_NEAR(shares_of(study, 1.0).found, predicted, 0.03) << difference;
  }
}

TEST(CrossedDifference, ValuesNeededFindTheDifferenceInFourOfFiveStudies) {
  // Independent runs of many blocks: the design effect is one.
  const double difference = 1.0, scatter = 2.0;
  const double needed = required_sample_size(difference, scatter, 1.0);
  EXPECT_NEAR(needed, 4.0 * 4.0 * std::pow(1.959964 + 0.841621, 2.0), 1e-3);
  CrossedStudy study;
  study.units = static_cast<std::uint32_t>(needed) / 2 * 2;
  study.points = 1;
  study.each = 1;
  study.of_unit = 0.0;
  study.of_half = 0.0;
  study.of_run = scatter;
  study.difference = difference;
  EXPECT_NEAR(shares_of(study, 1.0).found, kDefaultPower, 0.03);
  EXPECT_NEAR(test_power(minimum_detectable_difference(0.7, 12.0), 0.7, 12.0), kDefaultPower, 1e-6);
  EXPECT_EQ(minimum_detectable_difference(0.0, 12.0), 0.0);
  EXPECT_NEAR(test_power(0.0, 1.0, 8.0), 0.05, 1e-9);
}

TEST(CrossedDifference, IsNoneWithoutTwoUnitsInEachGroup) {
  CrossedSample sample{{1, 2, 3}, {false, true, true}, {0, 1, 2}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_FALSE(crossed_difference(sample));
  sample.strata.pop_back();
  EXPECT_TRUE(contains(refusal([&] { crossed_difference(sample); }), "each of its 3 values"));
}

}  // namespace
}  // namespace clast
