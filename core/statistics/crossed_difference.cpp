#include "core/statistics/crossed_difference.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/statistics/probability.hpp"

namespace clast {
namespace {

constexpr double kLevel = 0.05;

void check_crossed_sample(const CrossedSample& sample) {
  const std::size_t count = sample.values.size();
  if (sample.in_second_group.size() != count || sample.units.size() != count ||
      sample.points.size() != count || sample.strata.size() != count) {
    throw InputError("a difference needs a group, a unit, a point and a stratum for each of its " +
                     std::to_string(count) + " values");
  }
}

/// Values less the mean of their stratum.
std::vector<double> within_strata(const std::vector<double>& values,
                                  const std::vector<std::uint32_t>& strata) {
  std::map<std::uint32_t, std::pair<double, double>> sums;
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto& [sum, count] = sums[strata[i]];
    sum += values[i];
    count += 1.0;
  }
  std::vector<double> rest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& [sum, count] = sums.at(strata[i]);
    rest.push_back(values[i] - sum / count);
  }
  return rest;
}

/// Squares of the sums of scores over clusters, and how many clusters there are.
template <class Key>
std::pair<double, double> squared_sums(const std::vector<double>& scores,
                                       const std::function<Key(std::size_t)>& key) {
  std::map<Key, double> sums;
  for (std::size_t i = 0; i < scores.size(); ++i) sums[key(i)] += scores[i];
  double squares = 0.0;
  for (const auto& [cluster, sum] : sums) squares += sum * sum;
  return {squares, static_cast<double>(sums.size())};
}

/// Degrees of freedom between units: each group has a mean of its own unless a unit is in both.
double freedom_of_units(const CrossedSample& sample) {
  std::map<std::uint32_t, std::pair<bool, bool>> in;  // first group, second group
  for (std::size_t i = 0; i < sample.values.size(); ++i) {
    auto& [first, second] = in[sample.units[i]];
    (sample.in_second_group[i] ? second : first) = true;
  }
  double first = 0.0, second = 0.0;
  bool both = false;
  for (const auto& [unit, groups] : in) {
    first += groups.first ? 1.0 : 0.0;
    second += groups.second ? 1.0 : 0.0;
    both = both || (groups.first && groups.second);
  }
  const auto units = static_cast<double>(in.size());
  if (both) return units - 1.0;
  return first < 2.0 || second < 2.0 ? 0.0 : units - 2.0;
}

/// Variance of the sum of scores, and its degrees of freedom.
std::pair<double, double> variance_of(const CrossedSample& sample,
                                      const std::vector<double>& scores, double unit_freedom) {
  const auto [of_units, units] =
      squared_sums<std::uint32_t>(scores, [&](std::size_t i) { return sample.units[i]; });
  const auto [of_points, points] =
      squared_sums<std::uint32_t>(scores, [&](std::size_t i) { return sample.points[i]; });
  const auto [of_both, cells] = squared_sums<std::pair<std::uint32_t, std::uint32_t>>(
      scores, [&](std::size_t i) { return std::pair(sample.units[i], sample.points[i]); });
  const double by_units = of_units * units / unit_freedom;
  if (points < 2.0) return {by_units, unit_freedom};
  const double by_points = of_points * points / (points - 1.0);
  const double by_both = of_both * cells / std::max(1.0, cells - 2.0);
  const double whole = std::max({by_units + by_points - by_both, by_units, by_points});
  if (!(whole > 0.0)) return {0.0, unit_freedom};
  const double parts = by_units * by_units / unit_freedom + by_points * by_points / (points - 1.0);
  return {whole, whole * whole / parts};
}

}  // namespace

std::optional<CrossedDifference> crossed_difference(const CrossedSample& sample) {
  check_crossed_sample(sample);
  const std::size_t count = sample.values.size();
  const double unit_freedom = freedom_of_units(sample);
  if (!(unit_freedom >= 1.0)) return std::nullopt;
  const std::vector<double> values = within_strata(sample.values, sample.strata);
  const std::vector<double> group = within_strata(
      std::vector<double>(sample.in_second_group.begin(), sample.in_second_group.end()),
      sample.strata);
  double weight = 0.0, both = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    weight += group[i] * group[i];
    both += group[i] * values[i];
  }
  if (!(weight > 1e-9)) return std::nullopt;
  const double difference = both / weight;
  std::vector<double> scores;
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double rest = values[i] - difference * group[i];
    squares += rest * rest;
    scores.push_back(group[i] * rest);
  }
  const auto [variance, degrees_of_freedom] = variance_of(sample, scores, unit_freedom);
  const double standard_error = std::sqrt(variance) / weight;
  const double scatter = std::sqrt(squares / static_cast<double>(count));
  const double independent = scatter * scatter / weight;
  if (standard_error > 0.0) {
    return CrossedDifference{student_contrast(difference, standard_error, degrees_of_freedom),
                             scatter, standard_error * standard_error / independent};
  }
  CrossedDifference found;
  found.estimate = difference;
  found.standard_error = standard_error;
  found.degrees_of_freedom = degrees_of_freedom;
  found.interval = Interval{difference, difference};
  found.p_value = difference == 0.0 ? 1.0 : 0.0;
  found.scatter = scatter;
  return found;
}

double equivalence_p_value(const Contrast& found, double margin) {
  const double left = margin - std::abs(found.estimate);
  if (!(found.standard_error > 0.0)) return left > 0.0 ? 0.0 : 1.0;
  const double beyond =
      0.5 * student_two_sided_tail(left / found.standard_error, found.degrees_of_freedom);
  return left > 0.0 ? beyond : 1.0 - beyond;
}

double test_power(double difference, double standard_error, double degrees_of_freedom) {
  const double limit = student_quantile(1.0 - 0.5 * kLevel, degrees_of_freedom);
  const double centre = std::abs(difference) / standard_error;
  return noncentral_student_upper_tail(limit, degrees_of_freedom, centre) + 1.0 -
         noncentral_student_upper_tail(-limit, degrees_of_freedom, centre);
}

double minimum_detectable_difference(double standard_error, double degrees_of_freedom) {
  if (!(standard_error > 0.0)) return 0.0;
  double low = 0.0, high = standard_error;
  while (test_power(high, standard_error, degrees_of_freedom) < kDefaultPower) high *= 2.0;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (test_power(middle, standard_error, degrees_of_freedom) < kDefaultPower ? low : high) = middle;
  }
  return high;
}

double required_sample_size(double difference, double scatter, double design_effect) {
  const double z = normal_quantile(1.0 - 0.5 * kLevel) + normal_quantile(kDefaultPower);
  const double share = scatter * z / difference;
  return 4.0 * design_effect * share * share;
}

}  // namespace clast
