// Figures of realisations over files and their differences, against values written by hand.
#include "study/compare/deposit_quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "report/text/contrast_text.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::size_t figure_named(const std::string& name) {
  for (std::size_t i = 0; i < deposit_quantities().size(); ++i) {
    if (deposit_quantities()[i].name == name) return i;
  }
  throw std::out_of_range(name);
}

/// Ten blocks, of which nine lie, at the place where the toe is `length` from the crest and 5
/// lower.
DepositMeasures realisation(std::uint32_t file, std::uint32_t number, double length) {
  DepositMeasures deposit;
  deposit.file = file;
  deposit.realisation = number;
  deposit.blocks = 10;
  deposit.deposited_blocks = 9;
  deposit.volume = 6.0;
  deposit.crest = {1000.0, 2000.0, 50.0};
  deposit.toe = deposit.crest + Vec3(0.6 * length, 0.8 * length, -5.0);
  deposit.start_centre = {1000.0, 2000.0, 49.0};
  deposit.centre = deposit.start_centre + Vec3(3.0, -4.0, -2.0);
  deposit.area = 8.0;
  deposit.bulk_volume = 12.0;
  deposit.start_volume = 10.0;
  deposit.start_bulk_volume = 16.0;
  deposit.thickness = 2.5;
  deposit.energy = {{.normal = 0.3, .friction = 0.4}, {.friction = 0.2, .rolling = 0.1}, 5000.0};
  return deposit;
}

const DepositQuantityDifference& named(const DepositQuantityComparison& figures,
                                       const std::string& name) {
  for (const DepositQuantityDifference& one : figures.differences) {
    if (one.first.quantity == figure_named(name)) return one;
  }
  throw std::out_of_range(name);
}

TEST(RealisationFigures, AreThoseOfTheDeposit) {
  const DepositMeasures deposit = realisation(0, 0, 10.0);
  const auto value = [&](const char* name) {
    return deposit_quantities()[figure_named(name)].value(deposit);
  };
  EXPECT_DOUBLE_EQ(value("lying"), 9.0);
  EXPECT_DOUBLE_EQ(value("lying_share"), 0.9);
  EXPECT_DOUBLE_EQ(value("centre_distance_m"), 5.0);
  EXPECT_DOUBLE_EQ(value("centre_drop_m"), 2.0);
  EXPECT_DOUBLE_EQ(value("centre_drop_ratio"), 0.4);
  EXPECT_NEAR(value("toe_distance_m"), 10.0, 1e-9);
  EXPECT_NEAR(value("toe_drop_ratio"), 0.5, 1e-9);
  EXPECT_NEAR(value("travel_angle_deg"), 26.565051177, 1e-6);
  EXPECT_DOUBLE_EQ(value("solid_share"), 0.5);
  EXPECT_NEAR(value("first_solid_share"), 10.0 / 16.0, 1e-12);
  EXPECT_DOUBLE_EQ(value("dissipated_by_friction"), 0.6);
  EXPECT_DOUBLE_EQ(value("dissipated_between_blocks"), 0.3);
  EXPECT_DOUBLE_EQ(value("mean_thickness_m"), 1.5);
}

TEST(RealisationFigures, DifferByFileWithWelchsInterval) {
  const DepositQuantityComparison figures =
      compare_deposit_quantities({realisation(0, 0, 20.0), realisation(0, 1, 22.0),
                                  realisation(2, 0, 10.0), realisation(2, 1, 12.0)});
  ASSERT_EQ(figures.files.size(), 2 * deposit_quantities().size());
  const DepositQuantityDifference& length = named(figures, "toe_distance_m");
  EXPECT_EQ(length.first.file, 0u);
  EXPECT_EQ(length.second.file, 2u);
  EXPECT_EQ(length.first.summary.count, 2u);
  EXPECT_NEAR(length.first.minimum, 20.0, 1e-9);
  EXPECT_NEAR(length.estimate, 10.0, 1e-9);
  ASSERT_TRUE(length.interval);
  // 95 % of Student's t with two degrees of freedom; the standard error is sqrt(2).
  const double half_width = 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95)) * std::sqrt(2.0);
  EXPECT_NEAR(length.interval->low, 10.0 - half_width, 1e-7);
  EXPECT_NEAR(length.interval->high, 10.0 + half_width, 1e-7);
  // p is 0.0194, and three figures are tested: length, H / L, travel angle.
  EXPECT_EQ(length.family_size, 3u);
  EXPECT_GT(*length.holm_p_value, *length.p_value);
  // What never differs has neither interval nor verdict.
  const DepositQuantityDifference& area = named(figures, "area_m2");
  EXPECT_FALSE(area.interval);
  EXPECT_EQ(area.verdict(), ContrastVerdict::kUntested);
  EXPECT_TRUE(contains(describe_effect(area), "area: file 1 8.0 m\xC2\xB2, file 3 8.0 m\xC2\xB2;"));
  EXPECT_TRUE(
      contains(describe_effect(area), "no interval, because the realisations do not differ"));
}

TEST(RealisationFigures, AreDistinguishedWhereTheIntervalAndTheCorrectedTestSaySo) {
  const auto compared_lengths = [](const std::vector<double>& first,
                                   const std::vector<double>& second) {
    std::vector<DepositMeasures> all;
    for (const double length : first) all.push_back(realisation(0, 0, length));
    for (const double length : second) all.push_back(realisation(1, 0, length));
    return named(compare_deposit_quantities(all), "toe_distance_m");
  };
  const DepositQuantityDifference clear =
      compared_lengths({20.0, 21.0, 22.0, 21.0}, {10.0, 11.0, 12.0});
  EXPECT_EQ(clear.verdict(), ContrastVerdict::kSignificant);
  EXPECT_EQ(describe_effect(clear),
            "distance L from crest to toe: file 1 21.00 m, file 2 11.00 m; " +
                describe_difference(clear) + ", from 4 and 3 realisations");
  EXPECT_TRUE(contains(describe_difference(clear), "m more (")) << describe_difference(clear);
  const DepositQuantityDifference open = compared_lengths({20.0, 22.0}, {13.0, 15.0});
  EXPECT_EQ(open.verdict(), ContrastVerdict::kInsignificantAfterCorrection) << *open.holm_p_value;
  EXPECT_TRUE(
      contains(describe_effect(open), "; one of 3 differences tested can be this large by chance"));
  const DepositQuantityDifference none = compared_lengths({20.0, 22.0}, {20.5, 22.5});
  EXPECT_EQ(none.verdict(), ContrastVerdict::kInsignificant);
  EXPECT_TRUE(contains(describe_difference(none), "m less (")) << describe_difference(none);
  EXPECT_TRUE(describe_effect(none).ends_with("; not significant"));
  const DepositQuantityDifference single = compared_lengths({20.0, 22.0}, {10.0});
  EXPECT_EQ(single.verdict(), ContrastVerdict::kUntested);
  EXPECT_TRUE(
      contains(describe_effect(single), "an interval requires two realisations of each file"));
}

TEST(RealisationFigures, WithoutADepositAreLeftOut) {
  DepositMeasures empty;
  empty.blocks = 10;
  DepositMeasures other = empty;
  other.file = 1;
  const DepositQuantityComparison figures = compare_deposit_quantities({empty, other});
  for (const DepositQuantitySummary& one : figures.files) {
    EXPECT_TRUE(std::isfinite(one.summary.mean)) << deposit_quantities()[one.quantity].name;
  }
  EXPECT_THROW(named(figures, "area_m2"), std::out_of_range);
}

TEST(RealisationFigures, OfManyFilesAreNotComparedPairByPair) {
  std::vector<DepositMeasures> all;
  for (std::uint32_t file = 0; file < 13; ++file) all.push_back(realisation(file, 0, 20.0));
  EXPECT_TRUE(compare_deposit_quantities(all).differences.empty());
  all.pop_back();
  EXPECT_EQ(compare_deposit_quantities(all).differences.size(), 66 * deposit_quantities().size());
}

}  // namespace
}  // namespace clast
