#include "core/statistics/sample_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include "core/random.hpp"
#include "core/statistics/probability.hpp"

namespace clast {
namespace {

using Values = std::vector<double>;

double largest_distance(const Values& a, const Values& b) {
  const auto share_upto = [](const Values& sample, double x) {
    return static_cast<double>(std::count_if(sample.begin(), sample.end(),
                                             [&](double value) { return value <= x; })) /
           static_cast<double>(sample.size());
  };
  double distance = 0.0;
  for (const Values* sample : {&a, &b}) {
    for (const double x : *sample) {
      distance = std::max(distance, std::abs(share_upto(a, x) - share_upto(b, x)));
    }
  }
  return distance;
}

/// The share of all deals of the pooled values with at least the distance of the one given.
double p_of_all_deals(const Values& a, const Values& b) {
  Values all = a;
  all.insert(all.end(), b.begin(), b.end());
  const double found = largest_distance(a, b);
  int deals = 0, as_far = 0;
  for (unsigned mask = 0; mask < 1u << all.size(); ++mask) {
    if (static_cast<std::size_t>(std::popcount(mask)) != a.size()) continue;
    Values x, y;
    for (std::size_t i = 0; i < all.size(); ++i) (mask >> i & 1 ? x : y).push_back(all[i]);
    ++deals;
    as_far += largest_distance(x, y) >= found - 1e-12;
  }
  return static_cast<double>(as_far) / deals;
}

TEST(TwoSampleKs, EqualsTheCountOverAllDealsAlsoWithTies) {
  Random random(11);
  for (int trial = 0; trial < 40; ++trial) {
    Values a, b;
    const auto m = 1 + random.uniform_index(7), n = 1 + random.uniform_index(7);
    const std::uint64_t different = trial % 2 ? 4 : 1'000'000;  // ties in every second trial
    for (std::uint64_t i = 0; i < m; ++i)
      a.push_back(static_cast<double>(random.uniform_index(different)));
    for (std::uint64_t i = 0; i < n; ++i)
      b.push_back(static_cast<double>(random.uniform_index(different)));
    const auto test = two_sample_ks_test(a, b);
    ASSERT_TRUE(test);
    EXPECT_TRUE(test->exact);
    EXPECT_NEAR(test->statistic, largest_distance(a, b), 1e-15);
    EXPECT_NEAR(test->p_value, p_of_all_deals(a, b), 1e-12);
  }
}

// Gnedenko and Korolyuk: for m = n without ties,
// P(D >= k/n) = 2 sum over j >= 1 of (-1)^(j+1) C(2n, n - j k)/C(2n, n).
TEST(TwoSampleKs, OfEqualSamplesFollowsGnedenkoAndKorolyuk) {
  for (const int n : {5, 12, 50, 300}) {
    for (const int k : {1, n / 4 + 1, n / 3, n / 2, n}) {
      Values a, b;  // k values of a lie below all of b; from there on the two alternate
      for (int i = 0; i < n; ++i) {
        a.push_back(i);
        b.push_back(i + k - 0.5);
      }
      double expected = 0.0;
      for (int j = 1; j * k <= n; ++j) {
        expected += (j % 2 ? 2.0 : -2.0) *
                    std::exp(2.0 * std::lgamma(n + 1.0) - std::lgamma(n - j * k + 1.0) -
                             std::lgamma(n + j * k + 1.0));
      }
      const auto test = two_sample_ks_test(a, b);
      EXPECT_NEAR(test->statistic, static_cast<double>(k) / n, 1e-12);
      EXPECT_NEAR(test->p_value, expected, 1e-9) << n << ", " << k;
    }
  }
}

TEST(TwoSampleKs, OfLargeSamplesTakesKolmogorovsLimit) {
  Values a, b;
  for (int i = 0; i < 5000; ++i) a.push_back(i);
  for (int i = 0; i < 5000; ++i) b.push_back(i + 150.5);
  const auto test = two_sample_ks_test(a, b);
  EXPECT_FALSE(test->exact);
  EXPECT_NEAR(test->statistic, 151.0 / 5000.0, 1e-15);
  EXPECT_NEAR(test->p_value, kolmogorov_upper_tail(151.0 / 5000.0 * std::sqrt(2500.0)), 1e-15);
}

TEST(TwoSampleKs, KnowsNothingOfAnEmptySampleAndSeesNoneInEqualOnes) {
  EXPECT_FALSE(two_sample_ks_test({}, Values{1.0}));
  EXPECT_EQ(two_sample_ks_test(Values{1, 2, 3}, Values{3, 2, 1})->p_value, 1.0);
}

TEST(Ranks, TiesShareTheMean) {
  EXPECT_EQ(fractional_ranks(Values{3, 1, 3, 2, 3}), (Values{4, 1, 4, 2, 4}));
}

// Without ties rho = 1 - 6 sum d^2/(n (n^2 - 1)); for n = 4 the 24 orders give P(rho = 1) = 1/24.
TEST(Spearman, OfFourPairsCountsAllOrders) {
  const auto all = spearman_test(Values{1, 2, 3, 4}, Values{10, 20, 30, 40});
  EXPECT_DOUBLE_EQ(all->statistic, 1.0);
  EXPECT_NEAR(all->p_value, 2.0 / 24.0, 1e-15);
  const auto most = spearman_test(Values{1, 2, 3, 4}, Values{1, 2, 4, 3});
  EXPECT_NEAR(most->statistic, 0.8, 1e-15);       // sum d^2 = 2
  EXPECT_NEAR(most->p_value, 8.0 / 24.0, 1e-15);  // 1 + 3 orders at either end
}

// Without ties rho also follows from the squared differences of the ranks.
TEST(Spearman, BeyondNinePairsFollowsStudent) {
  Values x, y;
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    x.push_back(random.normal());
    y.push_back(0.3 * x.back() + random.normal());
  }
  const auto test = spearman_test(x, y);
  EXPECT_FALSE(test->exact);
  const Values rank_x = fractional_ranks(x), rank_y = fractional_ranks(y);
  double squares = 0.0;
  for (int i = 0; i < 200; ++i) squares += (rank_x[i] - rank_y[i]) * (rank_x[i] - rank_y[i]);
  const double rho = 1.0 - 6.0 * squares / (200.0 * (200.0 * 200.0 - 1.0));
  EXPECT_NEAR(test->statistic, rho, 1e-12);
  EXPECT_NEAR(test->p_value,
              student_two_sided_tail(rho * std::sqrt(198.0 / (1.0 - rho * rho)), 198), 1e-12);
  // Among samples without a relation one in twenty is below 5 %.
  int rejected = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Values u, v;
    for (int i = 0; i < 12; ++i) {
      u.push_back(random.normal());
      v.push_back(random.normal());
    }
    rejected += spearman_test(u, v)->p_value < 0.05;
  }
  EXPECT_NEAR(rejected, 20, 15);  // 3.4 standard deviations
}

TEST(Spearman, NeedsThreePairsThatVary) {
  EXPECT_FALSE(spearman_test(Values{1, 2}, Values{1, 2}));
  EXPECT_FALSE(spearman_test(Values{1, 2, 3}, Values{1, 1, 1}));
}

using Counts = std::vector<std::size_t>;

// 2 x 2: n (ad - bc)^2 / products of the sums; p is the normal's two tails beyond its root.
TEST(SameClasses, OfTwoClassesIsTheTextbookFormula) {
  const auto test = chi_squared_test(Counts{43, 46}, Counts{30, 70}, 1);
  const double n = 189.0, difference = 43.0 * 70.0 - 46.0 * 30.0;
  const double expected = n * difference * difference / (89.0 * 100.0 * 73.0 * 116.0);
  EXPECT_NEAR(test->chi_squared, expected, 1e-12);
  EXPECT_EQ(test->degrees_of_freedom, 1u);
  EXPECT_EQ(test->draws, 0u);
  EXPECT_NEAR(test->p_value, std::erfc(std::sqrt(expected / 2.0)), 1e-12);
  EXPECT_NEAR(test->smallest_expected, 73.0 * 89.0 / 189.0, 1e-12);
}

TEST(SameClasses, ClassesOfNeitherSampleAreLeftOut) {
  const auto with = chi_squared_test(Counts{20, 0, 30, 25}, Counts{30, 0, 20, 25}, 1);
  const auto without = chi_squared_test(Counts{20, 30, 25}, Counts{30, 20, 25}, 1);
  EXPECT_EQ(with->degrees_of_freedom, 2u);
  EXPECT_EQ(with->chi_squared, without->chi_squared);
  EXPECT_FALSE(chi_squared_test(Counts{5, 0}, Counts{7, 0}, 1));
  EXPECT_FALSE(chi_squared_test(Counts{5, 2}, Counts{0, 0}, 1));
}

/// p of a 2 x k table: the hypergeometric chances of all tables at least as extreme.
double p_of_all_tables(const Counts& a, const Counts& b) {
  std::size_t size_a = 0, size = 0;
  Counts total;
  for (std::size_t k = 0; k < a.size(); ++k) {
    total.push_back(a[k] + b[k]);
    size_a += a[k];
    size += total.back();
  }
  const auto log_choose = [](double n, double k) {
    return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
  };
  const auto chi = [&](const Counts& x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double e = double(total[k]) * double(size_a) / double(size);
      sum += (x[k] - e) * (x[k] - e) * (1.0 / e + 1.0 / (double(total[k]) - e));
    }
    return sum;
  };
  const double found = chi(a);
  double p = 0.0;
  Counts x(a.size(), 0);
  const std::function<void(std::size_t, std::size_t, double)> place =
      [&](std::size_t k, std::size_t left, double log_chance) {
        if (k + 1 == x.size()) {
          if (left > total[k]) return;
          x[k] = left;
          if (chi(x) >= found * (1 - 1e-9)) {
            p += std::exp(log_chance + log_choose(double(total[k]), double(left)) -
                          log_choose(double(size), double(size_a)));
          }
          return;
        }
        for (std::size_t c = 0; c <= std::min(left, total[k]); ++c) {
          x[k] = c;
          place(k + 1, left - c, log_chance + log_choose(double(total[k]), double(c)));
        }
      };
  place(0, size_a, 0.0);
  return p;
}

TEST(SameClasses, RareClassesAreJudgedByRandomTables) {
  for (const auto& [a, b] : {std::pair{Counts{6, 1, 3}, Counts{2, 5, 4}},
                             {Counts{9, 2, 0, 1}, Counts{3, 3, 4, 2}},
                             {Counts{40, 3}, Counts{35, 12}},
                             {Counts{3, 3, 3}, Counts{3, 3, 3}}}) {
    const auto test = chi_squared_test(a, b, 5, 40'000);
    EXPECT_LT(test->smallest_expected, 7.3);
    const double p = std::min(1.0, p_of_all_tables(a, b));
    if (test->smallest_expected < 5.0) {
      EXPECT_EQ(test->draws, 40'000u);
      EXPECT_NEAR(test->p_value, p, 4.0 * std::sqrt(p * (1.0 - p) / 40'000.0) + 5e-5) << p;
    }
  }
  // A rare class among a million blocks costs no more.
  const auto large =
      chi_squared_test(Counts{500'000, 499'998, 2}, Counts{400'000, 400'000, 4}, 5, 2000);
  EXPECT_EQ(large->draws, 2000u);
  EXPECT_GT(large->p_value, 0.2);
  EXPECT_EQ(chi_squared_test(Counts{6, 1, 3}, Counts{2, 5, 4}, 5)->p_value,
            chi_squared_test(Counts{6, 1, 3}, Counts{2, 5, 4}, 5)->p_value);
}

}  // namespace
}  // namespace clast
