#include "core/statistics/clustered_trend.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

constexpr std::size_t kAllOrders = 9;  ///< units, up to which every order is looked at

void check_trend_sample(const TrendSample& sample) {
  const std::size_t count = sample.values.size(), units = sample.property.size();
  if (sample.clusters.size() != count || sample.units.size() != count ||
      sample.strata.size() != units) {
    throw InputError("a trend needs a cluster and a unit for each of its " + std::to_string(count) +
                     " values, and a stratum for each unit");
  }
  for (const std::uint32_t unit : sample.units) {
    if (unit >= units) {
      throw InputError("there is no unit number " + std::to_string(unit) + " among " +
                       std::to_string(units));
    }
  }
}

/// Mean over the values of each unit of their ranks within the cluster, from 0 to 1.
std::vector<double> mean_ranks(const TrendSample& sample) {
  std::map<std::uint32_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < sample.values.size(); ++i) members[sample.clusters[i]].push_back(i);
  std::vector<double> sums(sample.property.size(), 0.0), counts(sample.property.size(), 0.0);
  for (const auto& [cluster, points] : members) {
    std::vector<double> values;
    for (const std::size_t i : points) values.push_back(sample.values[i]);
    const std::vector<double> rank = fractional_ranks(values);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint32_t unit = sample.units[points[k]];
      sums[unit] += (rank[k] - 0.5) / static_cast<double>(points.size());
      counts[unit] += 1.0;
    }
  }
  for (std::size_t unit = 0; unit < sums.size(); ++unit) {
    if (counts[unit] > 0.0) sums[unit] /= counts[unit];
  }
  return sums;
}

std::vector<double> centred_ranks(const std::vector<double>& values) {
  std::vector<double> centred = fractional_ranks(values);
  for (double& rank : centred) rank -= 0.5 * (static_cast<double>(values.size()) + 1.0);
  return centred;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Centred ranks of the units of a stratum.
struct Stratum {
  std::vector<double> property, outcome;
};

std::vector<Stratum> strata_of(const TrendSample& sample) {
  const std::vector<double> means = mean_ranks(sample);
  std::vector<bool> met(sample.property.size(), false);
  for (const std::uint32_t unit : sample.units) met[unit] = true;
  std::map<std::uint32_t, Stratum> by_number;
  for (std::size_t unit = 0; unit < sample.property.size(); ++unit) {
    if (!met[unit]) continue;
    Stratum& stratum = by_number[sample.strata[unit]];
    stratum.property.push_back(sample.property[unit]);
    stratum.outcome.push_back(means[unit]);
  }
  std::vector<Stratum> strata;
  for (auto& [number, stratum] : by_number) {
    const auto [least, most] =
        std::minmax_element(stratum.property.begin(), stratum.property.end());
    if (*least == *most) continue;  // nothing to exchange
    strata.push_back({centred_ranks(stratum.property), centred_ranks(stratum.outcome)});
  }
  return strata;
}

}  // namespace

std::optional<TestResult> clustered_trend_test(const TrendSample& sample, std::uint64_t seed,
                                               std::size_t draws) {
  check_trend_sample(sample);
  std::vector<Stratum> strata = strata_of(sample);
  std::size_t units = 0;
  double of_property = 0.0, of_outcome = 0.0;
  for (const Stratum& stratum : strata) {
    units += stratum.property.size();
    of_property += product(stratum.property, stratum.property);
    of_outcome += product(stratum.outcome, stratum.outcome);
  }
  if (units < 3 || !(of_property > 0.0) || !(of_outcome > 0.0)) return std::nullopt;
  if (strata.size() == 1 && units <= kAllOrders) {
    return spearman_test(strata.front().property, strata.front().outcome);
  }
  const double scale = 1.0 / std::sqrt(of_property * of_outcome);
  const auto statistic = [&] {
    double sum = 0.0;
    for (const Stratum& stratum : strata) sum += product(stratum.property, stratum.outcome);
    return sum * scale;
  };
  constexpr double kSame = 1e-12;  ///< sums in another order
  TestResult result{statistic(), 1.0, false};
  std::size_t as_far = 0;
  Random random(seed);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    for (Stratum& stratum : strata) {
      for (std::size_t i = stratum.property.size(); i > 1; --i) {
        std::swap(stratum.property[i - 1], stratum.property[random.uniform_index(i)]);
      }
    }
    as_far += std::abs(statistic()) >= std::abs(result.statistic) - kSame ? 1 : 0;
  }
  result.p_value = static_cast<double>(1 + as_far) / static_cast<double>(1 + draws);
  return result;
}

}  // namespace clast
