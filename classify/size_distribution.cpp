#include "classify/size_distribution.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "core/statistics/probability.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

constexpr double kEulerGamma = 0.57721566490153286;
constexpr std::size_t kMaxDrawn = 1000;  // D/sqrt(n) changes by 0.1 % beyond

/// Sums that both fits need, with weights that sum to one.
struct LogSample {
  std::vector<double> logs;
  std::vector<double> weights;  ///< empty: all alike
  double effective = 0.0;       ///< (sum of w)^2 / sum of w^2
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation, divided by n

  double weight(std::size_t i) const {
    return weights.empty() ? 1.0 / static_cast<double>(logs.size()) : weights[i];
  }
};

LogSample log_sample(std::span<const double> sizes, std::span<const double> weights) {
  LogSample sample;
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double weight = weights.empty() ? 1.0 : weights[i];
    if (weight == 0.0) continue;
    sample.logs.push_back(std::log(sizes[i]));
    if (!weights.empty()) sample.weights.push_back(weight);
    sum += weight;
    squares += weight * weight;
  }
  if (sample.logs.empty()) return sample;
  for (double& weight : sample.weights) weight /= sum;
  sample.effective = sum * sum / squares;
  for (std::size_t i = 0; i < sample.logs.size(); ++i) {
    sample.mean += sample.weight(i) * sample.logs[i];
  }
  for (std::size_t i = 0; i < sample.logs.size(); ++i) {
    const double off = sample.logs[i] - sample.mean;
    sample.deviation += sample.weight(i) * off * off;
  }
  sample.deviation = std::sqrt(sample.deviation);
  return sample;
}

FittedSizeLaw log_normal(const LogSample& sample) {
  FittedSizeLaw law;
  law.kind = SizeLawKind::kLogNormal;
  const double root = std::sqrt(sample.effective);
  law.location = std::exp(sample.mean);
  law.location_error = law.location * sample.deviation / root;
  law.spread = sample.deviation;
  law.spread_error = sample.deviation / (std::sqrt(2.0) * root);
  return law;
}

/// Maximum likelihood of Weibull's distribution. With y = ln d - mean, the exponent n solves
/// sum w y e^(n y) / sum w e^(n y) = 1/n; the left side rises from 0, so there is one root.
FittedSizeLaw rosin_rammler(const LogSample& sample) {
  // Moments of ln d, whose standard deviation is pi/(sqrt 6 n), are a start within some per cent.
  double exponent = kPi / (std::sqrt(6.0) * sample.deviation);
  double zeroth = 0.0;
  for (int iteration = 0; iteration < 100; ++iteration) {
    double first = 0.0, second = 0.0;
    zeroth = 0.0;
    for (std::size_t i = 0; i < sample.logs.size(); ++i) {
      const double y = sample.logs[i] - sample.mean;
      const double term = sample.weight(i) * std::exp(exponent * y);
      zeroth += term;
      first += term * y;
      second += term * y * y;
    }
    const double mean = first / zeroth;
    const double slope = second / zeroth - mean * mean + 1.0 / (exponent * exponent);
    const double step = (mean - 1.0 / exponent) / slope;
    // Newton's steps overshoot below zero only from far above the root: halve instead.
    const double next = step < exponent ? exponent - step : 0.5 * exponent;
    const bool settled = std::abs(next - exponent) <= 1e-13 * exponent;
    exponent = next;
    if (settled) break;
  }
  FittedSizeLaw law;
  law.kind = SizeLawKind::kRosinRammler;
  const double root = std::sqrt(sample.effective);
  law.spread = exponent;
  law.location = std::exp(sample.mean + std::log(zeroth) / exponent);
  law.spread_error = exponent * std::sqrt(6.0) / kPi / root;
  law.location_error =
      law.location / exponent *
      std::sqrt(1.0 + 6.0 * (1.0 - kEulerGamma) * (1.0 - kEulerGamma) / (kPi * kPi)) / root;
  return law;
}

double drawn_size(const FittedSizeLaw& law, Random& random) {
  if (law.kind == SizeLawKind::kLogNormal)
    return law.location * std::exp(law.spread * random.normal());
  return law.location * std::pow(-std::log1p(-random.uniform()), 1.0 / law.spread);
}

/// Rounds a size to the reading step; at least one step, since no block has size 0.
double read_to(double step, double size) {
  return step > 0.0 ? std::max(1.0, std::round(size / step)) * step : size;
}

/// Largest distance of the curves; between readings only when there is a step.
/// @param sorted  ascending
/// @param weight  of the i-th of them; they sum to one
template <class Weight>
double curve_distance(const FittedSizeLaw& law, std::span<const double> sorted, double step,
                      Weight weight) {
  double distance = 0.0, share = 0.0;
  for (std::size_t i = 0; i < sorted.size();) {
    const double value = read_to(step, sorted[i]);
    const double before = share;
    // Readings of one step are equal on paper, not in their last bits.
    for (; i < sorted.size() && read_to(step, sorted[i]) <= value + 0.25 * step; ++i) {
      share += weight(i);
    }
    if (step == 0.0) {
      const double below = law.fraction_below(value);
      distance = std::max({distance, below - before, share - below});
    } else {
      distance =
          std::max({distance, std::abs(law.fraction_below(value + 0.5 * step) - share),
                    std::abs(law.fraction_below(std::max(0.0, value - 0.5 * step)) - before)});
    }
  }
  return distance;
}

double curve_distance(const FittedSizeLaw& law, std::span<const double> sorted, double step) {
  const double each = 1.0 / static_cast<double>(sorted.size());
  return curve_distance(law, sorted, step, [each](std::size_t) { return each; });
}

SizeCurve curve_by_number(const std::vector<double>& sizes, double step, std::uint64_t seed) {
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  SizeCurve curve{.blocks = sizes.size(),
                  .d10 = quantile(sorted, 0.1),
                  .d50 = quantile(sorted, 0.5),
                  .d90 = quantile(sorted, 0.9),
                  .laws = {}};
  for (const SizeLawKind kind : {SizeLawKind::kLogNormal, SizeLawKind::kRosinRammler}) {
    std::optional<FittedSizeLaw> law = fit_size_law(kind, sorted);
    if (!law) continue;
    compute_goodness_of_fit(*law, sorted, step, seed);
    curve.laws.push_back(*law);
  }
  return curve;
}

std::optional<SizeCurve> curve_by_mass(const std::vector<double>& sizes,
                                       const std::vector<double>& weights, double step) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (weights[i] > 0.0) order.push_back(i);
  }
  if (order.empty()) return std::nullopt;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  std::vector<double> sorted, mass;
  for (const std::size_t i : order) {
    sorted.push_back(sizes[i]);
    mass.push_back(weights[i]);
  }
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  SizeCurve curve{.blocks = order.size(),
                  .d10 = weighted_percentile(sorted, mass, 0.1),
                  .d50 = weighted_percentile(sorted, mass, 0.5),
                  .d90 = weighted_percentile(sorted, mass, 0.9),
                  .laws = {}};
  for (const SizeLawKind kind : {SizeLawKind::kLogNormal, SizeLawKind::kRosinRammler}) {
    std::optional<FittedSizeLaw> law = fit_size_law(kind, sorted, mass);
    if (!law) continue;
    law->distance =
        curve_distance(*law, sorted, step, [&](std::size_t i) { return mass[i] / total; });
    curve.laws.push_back(*law);
  }
  return curve;
}

}  // namespace

double block_size(const Axes& axes, SizeMeasure measure) {
  return measure == SizeMeasure::kIntermediate ? axes.I : std::cbrt(axes.L * axes.I * axes.S);
}

std::string name_of(SizeMeasure measure) {
  return measure == SizeMeasure::kIntermediate ? "I" : "(L I S)^(1/3)";
}

std::string name_of(SizeLawKind kind) {
  return kind == SizeLawKind::kLogNormal ? "log-normal" : "Rosin-Rammler";
}

double FittedSizeLaw::fraction_below(double size) const {
  if (!(size > 0.0)) return 0.0;
  if (kind == SizeLawKind::kLogNormal) return normal_cdf(std::log(size / location) / spread);
  return -std::expm1(-std::pow(size / location, spread));
}

std::optional<FittedSizeLaw> fit_size_law(SizeLawKind kind, std::span<const double> sizes,
                                          std::span<const double> weights) {
  assert(weights.empty() || weights.size() == sizes.size());
  const LogSample sample = log_sample(sizes, weights);
  // Sizes that differ by rounding alone have no distribution.
  if (sample.logs.size() < 2 || !(sample.deviation > 1e-9)) return std::nullopt;
  return kind == SizeLawKind::kLogNormal ? log_normal(sample) : rosin_rammler(sample);
}

double find_reading_resolution(std::span<const double> values) {
  if (values.empty()) return 0.0;
  const double largest = *std::max_element(values.begin(), values.end());
  const double same = 1e-6 * largest, smallest = 1e-4 * largest;
  double step = 0.0;
  for (const double value : values) {  // Euclid's algorithm with a tolerance
    double a = std::max(step, value), b = std::min(step, value);
    while (b > same) {
      const double rest = std::abs(a - b * std::round(a / b));
      a = b;
      b = rest;
    }
    step = a;
    if (step < smallest) return 0.0;
  }
  // One size measured more finely than the others must not hide the step of the rest.
  const double divisor = largest / std::round(largest / step);  // sheds the rounding of the steps
  step = divisor;
  for (const double factor : {2.0, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0}) {
    const double wider = factor * divisor;
    const auto on_it = std::count_if(values.begin(), values.end(), [&](double value) {
      return std::abs(value - wider * std::round(value / wider)) <= same;
    });
    if (10 * static_cast<std::size_t>(on_it) >= 9 * values.size()) step = wider;
  }
  // One value, or all equal, are multiples of themselves and do not show how they were read.
  return step < 0.5 * largest ? step : 0.0;
}

std::vector<double> bootstrap_ks_distances(const FittedSizeLaw& law, std::size_t count, double step,
                                           std::uint64_t seed, std::size_t samples) {
  Random random(seed);
  std::vector<double> drawn(count), distances;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    for (double& size : drawn) size = read_to(step, drawn_size(law, random));
    std::sort(drawn.begin(), drawn.end());
    if (const auto own = fit_size_law(law.kind, drawn)) {
      distances.push_back(curve_distance(*own, drawn, step));
    }
  }
  return distances;
}

void compute_goodness_of_fit(FittedSizeLaw& law, std::span<const double> sizes, double step,
                             std::uint64_t seed, std::size_t samples) {
  std::vector<double> sorted(sizes.begin(), sizes.end());
  std::sort(sorted.begin(), sorted.end());
  law.distance = curve_distance(law, sorted, step);
  const std::size_t count = std::min(sizes.size(), kMaxDrawn);
  const double scale = std::sqrt(static_cast<double>(sizes.size()) / static_cast<double>(count));
  const std::vector<double> chance = bootstrap_ks_distances(law, count, step, seed, samples);
  const auto as_far = std::count_if(chance.begin(), chance.end(),
                                    [&](double d) { return d >= law.distance * scale; });
  law.p_value = static_cast<double>(1 + as_far) / static_cast<double>(1 + chance.size());
}

double weighted_percentile(std::span<const double> sizes, std::span<const double> weights,
                           double share) {
  return weighted_percentiles(sizes, weights, std::span(&share, 1)).front();
}

std::vector<double> weighted_percentiles(std::span<const double> sizes,
                                         std::span<const double> weights,
                                         std::span<const double> fractions) {
  assert(!sizes.empty() && sizes.size() == weights.size());
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<double> percentiles;
  for (const double fraction : fractions) {
    double sum = 0.0;
    std::size_t last = order.back();
    for (const std::size_t i : order) {
      sum += weights[i];
      // Sums of the same weights in another order differ in their last bits.
      if (sum < fraction * total * (1.0 - 1e-12)) continue;
      last = i;
      break;
    }
    percentiles.push_back(sizes[last]);
  }
  return percentiles;
}

SizeDistribution size_distribution(const Population& population, SizeMeasure measure,
                                   std::uint64_t seed) {
  assert(!population.blocks.empty());
  std::vector<double> sizes;
  sizes.reserve(population.blocks.size());
  std::vector<double> weights;
  const std::vector<double> mass = block_masses(population);
  for (std::size_t i = 0; i < mass.size(); ++i) {
    if (population.blocks[i].unscaled) continue;
    sizes.push_back(block_size(population.blocks[i].axes, measure));
    weights.push_back(mass[i]);
  }
  SizeDistribution distribution;
  distribution.measure = measure;
  if (sizes.empty()) return distribution;
  distribution.step = find_reading_resolution(sizes);
  distribution.by_number = curve_by_number(sizes, distribution.step, seed);
  distribution.by_mass = curve_by_mass(sizes, weights, distribution.step);
  distribution.total_mass = std::accumulate(weights.begin(), weights.end(), 0.0);
  return distribution;
}

}  // namespace clast
