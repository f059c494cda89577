// Differences between groups: against other ways to the same numbers, and none where there is none.
#include "study/compare/differences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "core/statistics/sample_tests.hpp"
#include "report/text/contrast_text.hpp"
#include "study/compare/comparison.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/study/table_csv.hpp"

namespace clast {
namespace {

/// A campaign whose runs stop at x = 20 + place of the release point + scatter, plus `shift` for
/// the elongated block: eight release points, so many runs of each block at each.
CampaignResults synthetic_results(std::uint64_t seed, double shift, int runs_per_point = 12) {
  Random random(seed);
  CampaignResults results = hand_made_results();
  results.barriers.clear();
  results.crossings.clear();
  results.runs.clear();
  results.release_points.assign(8, Vec3(0.0, 0.0, 2.0));
  std::vector<double> places;
  for (int point = 0; point < 8; ++point) places.push_back(4.0 * random.normal());
  for (std::uint32_t block = 0; block < 2; ++block) {
    for (std::uint32_t point = 0; point < 8; ++point) {
      for (int i = 0; i < runs_per_point; ++i) {
        const double x = 20.0 + places[point] + 3.0 * random.normal() + block * shift;
        RunRecord run = hand_made_run(static_cast<std::uint32_t>(results.runs.size()), block, x,
                                      2.0 * random.normal());
        run.point = point;
        run.result.max_speed = 8.0 + random.normal();
        run.result.path_length = 1.2 * x + random.uniform();
        results.runs.push_back(run);
      }
    }
  }
  results.planned_runs = static_cast<std::uint32_t>(results.runs.size());
  return results;
}

const GroupDifference& between_classes(const Comparison& comparison, const std::string& quantity) {
  for (const GroupDifference& one : comparison.differences) {
    if (comparison.groups[one.first].kind == RunGroupKind::kGarcia && one.quantity == quantity) {
      return one;
    }
  }
  throw std::runtime_error("no difference in " + quantity);
}

TEST(Differences, OneBlockEnteredAsTwoClassesIsSeldomCalledDifferent) {
  int flagged = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Comparison comparison = compared(synthetic_results(seed, 0.0));
    bool any = false;
    for (const GroupDifference& one : comparison.differences) {
      any = any ||
            (comparison.groups[one.first].kind == RunGroupKind::kGarcia && one.is_significant());
    }
    flagged += any ? 1 : 0;
  }
  RecordProperty("flagged_of_100", flagged);
  EXPECT_LE(flagged, 10);
}

TEST(Differences, OneThatIsThereIsFoundWithItsSize) {
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Comparison comparison = compared(synthetic_results(seed, -3.0));
    const GroupDifference& runout = between_classes(comparison, "runout_m");
    EXPECT_TRUE(runout.is_significant()) << seed;
    EXPECT_EQ(runout.points, 8u);
    EXPECT_EQ(runout.family_size, 4u);
    EXPECT_GT(runout.cliffs_delta, 0.0);
    // Clusters that both classes share leave the scatter only: 3 sqrt(2/96) = 0.43 m.
    ASSERT_TRUE(runout.interval);
    EXPECT_LT(runout.interval->high - runout.interval->low, 4 * 1.96 * 0.43);
    inside += runout.interval->low <= 3.0 && 3.0 <= runout.interval->high ? 1 : 0;
  }
  // Eight clusters make intervals that are a little too narrow; nine in ten is what is known of it.
  EXPECT_GE(inside, 15);
}

/// Puts the runs of both blocks into so many realisations.
CampaignResults in_realisations(CampaignResults results, std::uint32_t realisations) {
  std::stable_sort(results.runs.begin(), results.runs.end(),
                   [](const RunRecord& a, const RunRecord& b) { return a.point < b.point; });
  for (std::uint32_t i = 0; i < results.runs.size(); ++i) results.runs[i].run = i;
  results.persistent_blocks = {results.planned_runs / realisations, {0.01, 0.5, 0.3}, true};
  for (const RunRecord& run : results.runs)
    results.persistent_block_records.push_back({.run = run.run});
  return results;
}

// Blocks of one realisation depend on each other, however many they are and however far apart.
TEST(Differences, OneRealisationGivesNeitherIntervalNorTest) {
  const Comparison one = compared(in_realisations(synthetic_results(3, -30.0), 1));
  ASSERT_FALSE(one.differences.empty());
  for (const GroupDifference& difference : one.differences) {
    EXPECT_FALSE(difference.interval);
    EXPECT_FALSE(difference.p_value);
    EXPECT_FALSE(difference.holm_p_value);
    EXPECT_FALSE(difference.is_significant());
    EXPECT_EQ(difference.family_size, 0u);
    EXPECT_EQ(difference.verdict(), ContrastVerdict::kUntested);
    EXPECT_NE(describe_effect(difference, one)
                  .find("with one realisation, significance cannot be tested"),
              std::string::npos);
    EXPECT_GT(difference.ks_distance, 0.0) << "how far apart they are is known";
  }
  const CsvTable table = read_csv(table_csv(one, "differences"));
  for (const auto& row : table.rows) {
    for (const char* column : {"difference_low", "difference_high", "p_value", "p_holm", "found"}) {
      EXPECT_EQ(row.at(column), "") << column;
    }
  }
  const Comparison two = compared(in_realisations(synthetic_results(3, -30.0), 2));
  EXPECT_TRUE(between_classes(two, "runout_m").interval);
  EXPECT_TRUE(between_classes(two, "runout_m").holm_p_value);
}

// A file of one realisation beside one of several: its own scatter is not known.
TEST(Differences, EachGroupNeedsTwoRealisations) {
  CampaignResults several = in_realisations(synthetic_results(3, 0.0), 4);
  CampaignResults one = in_realisations(synthetic_results(4, 0.0), 1);
  std::erase_if(several.runs, [](const RunRecord& run) { return run.block == 1; });
  std::erase_if(one.runs, [](const RunRecord& run) { return run.block == 0; });
  for (CampaignResults* results : {&several, &one}) {
    results->planned_runs = static_cast<std::uint32_t>(results->runs.size());
  }
  one.campaign_sha256 = std::string(64, 'd');
  std::vector<CampaignResults> files;
  files.push_back(std::move(several));
  files.push_back(std::move(one));
  const Comparison comparison = compare(std::move(files));
  EXPECT_FALSE(between_classes(comparison, "runout_m").interval);
  EXPECT_FALSE(between_classes(comparison, "runout_m").p_value);
}

TEST(Differences, AgreeWithAnIndependentEvaluationOfTheTable) {
  const Comparison comparison = compared(synthetic_results(5, -2.0));
  const CsvTable runs = read_csv(table_csv(comparison, "runs"));
  std::map<std::string, std::vector<double>> runouts;
  for (std::size_t i = 0; i < runs.rows.size(); ++i) {
    runouts[runs.rows[i].at("shape")].push_back(runs.number(i, "runout_m"));
  }
  const std::vector<double>&a = runouts.at("compact"), &b = runouts.at("elongated");
  double balance = 0.0, mean_a = 0.0, mean_b = 0.0, largest = 0.0;
  for (const double x : a) {
    for (const double y : b) balance += x > y ? 1.0 : x < y ? -1.0 : 0.0;
    mean_a += x / static_cast<double>(a.size());
  }
  for (const double y : b) mean_b += y / static_cast<double>(b.size());
  for (const std::vector<double>* values : {&a, &b}) {
    for (const double at : *values) {
      const auto share = [&](const std::vector<double>& of) {
        double below = 0.0;
        for (const double value : of) below += value <= at ? 1.0 : 0.0;
        return below / static_cast<double>(of.size());
      };
      largest = std::max(largest, std::abs(share(a) - share(b)));
    }
  }
  const CsvTable table = read_csv(table_csv(comparison, "differences"));
  const GroupDifference& runout = between_classes(comparison, "runout_m");
  std::size_t row = 0;
  while (table.rows.at(row).at("quantity") != "runout_m" ||
         table.rows[row].at("first") != "class compact") {
    ++row;
  }
  EXPECT_NEAR(table.number(row, "cliffs_delta"), balance / static_cast<double>(a.size() * b.size()),
              1e-12);
  EXPECT_NEAR(table.number(row, "difference"), mean_a - mean_b, 1e-10);
  EXPECT_NEAR(table.number(row, "ks_distance"), largest, 1e-12);
  EXPECT_EQ(table.number(row, "p_value"), runout.p_value);
  // Holm's correction of the four tests of this pair, from the table.
  std::vector<double> p_values;
  for (const CsvTable::Row& other : table.rows) {
    if (other.at("first") == "class compact") {
      p_values.push_back(std::strtod(other.at("p_value").c_str(), nullptr));
    }
  }
  ASSERT_EQ(p_values.size(), 4u);
  std::sort(p_values.begin(), p_values.end());
  double corrected = 0.0;
  for (std::size_t i = 0; i < 4 && p_values[i] <= runout.p_value; ++i) {
    corrected = std::max(corrected, static_cast<double>(4 - i) * p_values[i]);
  }
  EXPECT_NEAR(table.number(row, "p_holm"), std::min(1.0, corrected), 1e-15);
  EXPECT_TRUE(table.rows[row].at("words").starts_with("runout: class compact "));
}

TEST(Differences, AreSaidInASentence) {
  const Comparison comparison = compared(synthetic_results(5, -6.0));
  const GroupDifference& runout = between_classes(comparison, "runout_m");
  const Interval& interval = runout.interval.value();
  const int decimals = significant_decimals(interval, 4);
  EXPECT_EQ(describe_effect(runout, comparison),
            "runout: class compact " + format_significant(runout.first_mean, 3) +
                " m on average, class elongated " + format_significant(runout.second_mean, 3) +
                " m; " + format_decimals(runout.first_mean - runout.second_mean, decimals) +
                " m more (" + format_decimals(interval.low, decimals) + " to " +
                format_decimals(interval.high, decimals) + " m)");
  const Comparison same = compared(synthetic_results(5, 0.0));
  EXPECT_TRUE(describe_effect(between_classes(same, "runout_m"), same)
                  .ends_with(", which is not significant among 4 differences"));
  // The other way round: less, with an interval that rises all the same.
  GroupDifference back = runout;
  std::swap(back.first, back.second);
  std::swap(back.first_mean, back.second_mean);
  back.estimate = -runout.estimate;
  back.interval = Interval{-interval.high, -interval.low};
  EXPECT_EQ(describe_difference(back),
            format_decimals(runout.first_mean - runout.second_mean, decimals) + " m less (" +
                format_decimals(interval.low, decimals) + " to " +
                format_decimals(interval.high, decimals) + " m)");
}

TEST(Differences, NameTheirQuantitiesForReaders) {
  EXPECT_EQ(quantity_label("path_length_m").name, "path length");
  const QuantityLabel energy = quantity_label("lower road total_energy_j");
  EXPECT_EQ(energy.name, "energy at lower road");
  EXPECT_EQ(energy.unit, "kJ");
  EXPECT_EQ(energy.factor * 5000.0, 5.0);
}

TEST(Differences, GroupsOfTwoRunsAreNotCompared) {
  const Comparison comparison = compared(hand_made_results());  // four runs against two
  EXPECT_TRUE(comparison.differences.empty());
}

TEST(Columns, GroupRunsByValueOrQuarter) {
  std::vector<CampaignResults> all;
  all.push_back(synthetic_results(1, 0.0));
  const Comparison comparison =
      compare(std::move(all), {.by = {"point", "max_speed_m_s"}, .measured = {}, .margin = {}});
  std::size_t points = 0, quarters = 0;
  for (const RunGroup& group : comparison.groups) {
    if (group.column == "point") {
      EXPECT_EQ(group.name, "point " + std::to_string(points++));
      EXPECT_EQ(group.rows.size(), 24u);
    } else if (group.column == "max_speed_m_s") {
      ++quarters;
      EXPECT_EQ(group.rows.size(), 48u) << group.name;
      EXPECT_NE(group.name.find(" to "), std::string::npos);
    }
  }
  EXPECT_EQ(points, 8u);
  EXPECT_EQ(quarters, 4u);
  std::vector<CampaignResults> one;
  one.push_back(synthetic_results(1, 0.0));
  try {
    compare(std::move(one), {.by = {"colour"}, .measured = {}, .margin = {}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no column \"colour\""), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("release_set"), std::string::npos);
  }
}

}  // namespace
}  // namespace clast
