#include "study/campaign/distribution.hpp"

#include <algorithm>
#include <cmath>

#include "core/statistics/probability.hpp"

namespace clast {
namespace {

double drawn_once(const Distribution& number, Random& random) {
  switch (number.law) {
    case Distribution::Law::kFixed:
      return number.first;
    case Distribution::Law::kUniform:
      return random.uniform(number.first, number.second);
    case Distribution::Law::kNormal:
      return number.first + number.second * random.normal();
    case Distribution::Law::kLogNormal:
      return number.first * std::exp(number.second * random.normal());
  }
  return number.first;
}

}  // namespace

double Distribution::central_value() const {
  return law == Law::kUniform ? 0.5 * (first + second) : first;
}

double Distribution::mean() const {
  if (law == Law::kFixed || law == Law::kUniform) return central_value();
  // Limits of a truncated law, in standard deviations from its middle.
  const auto deviations = [&](double value) {
    if (law == Law::kNormal) return (value - first) / second;
    return value > 0.0 ? std::log(value / first) / second : -1e300;
  };
  const double from = deviations(low), to = deviations(high);
  const double all = normal_cdf(to) - normal_cdf(from);
  if (law == Law::kLogNormal) {
    return first * std::exp(0.5 * second * second) *
           (normal_cdf(to - second) - normal_cdf(from - second)) / all;
  }
  const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * kPi); };
  return first + second * (density(from) - density(to)) / all;
}

double Distribution::draw(Random& random) const {
  // Mean and median lie inside the range, so about every second draw does at worst.
  while (true) {
    const double value = drawn_once(*this, random);
    if (is_fixed() || (value > low && value <= high)) return value;
  }
}

double Distribution::quantile(double below) const {
  // Shares of a normal law that no draw in a campaign is beyond.
  constexpr double kLeast = 1e-12;
  if (is_fixed()) return first;
  if (law == Law::kUniform) return first + (second - first) * below;
  const auto probability_below = [&](double value) {
    if (law == Law::kNormal) return normal_cdf((value - first) / second);
    return value > 0.0 ? normal_cdf(std::log(value / first) / second) : 0.0;
  };
  const double from = probability_below(low), to = probability_below(high);
  const double z = normal_quantile(std::clamp(from + (to - from) * below, kLeast, 1.0 - kLeast));
  const double value = law == Law::kNormal ? first + second * z : first * std::exp(second * z);
  return std::clamp(value, low, high);
}

}  // namespace clast
