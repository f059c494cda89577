#include "classify/scanned_deposit.hpp"

#include <algorithm>
#include <cmath>

#include "classify/size_draws.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "core/statistics/bootstrap.hpp"

namespace clast {
namespace {

constexpr std::size_t kReplicates = 400;
/// Variance of proportions over that of the replicates, since errors of the blocks of one deposit
/// are alike (docs/theory/deposits.md).
constexpr double kVarianceFactor = 3.0;

/// Sizes of the blocks of a deposit and their weights: medians, or those of one replicate.
struct WeighedBlocks {
  std::vector<BlockSizes> sizes;
  std::array<std::vector<double>, kSizeWeightings.size()> weights;
};

double quantity_of(const BlockSizes& sizes, std::size_t quantity) {
  return std::array{sizes.axes.L, sizes.axes.I, sizes.axes.S, sizes.volume}[quantity];
}

/// Weights of a block with given sizes, without the chance of being found.
std::array<double, kSizeWeightings.size()> weights_of(const DepositObservation& seen,
                                                      double probability) {
  return {1.0, seen.plan_area, seen.exposed_area, 1.0 / probability};
}

/// Draws a factor with mean 1 and the given variance.
double draw_factor(double variance, Random& random) {
  const double spread = std::sqrt(std::log1p(variance));
  return std::exp(spread * random.normal() - 0.5 * spread * spread);
}

using DepositBlocks = std::vector<const MeasuredBlock*>;

WeighedBlocks weigh_medians(const DepositBlocks& blocks, const VisibilityCorrection& correction) {
  WeighedBlocks all;
  for (const MeasuredBlock* block : blocks) {
    const DepositObservation& seen = *block->deposit;
    all.sizes.push_back(median_block_sizes(*block));
    const double probability = correction.inclusion_probability(all.sizes.back().axes.I);
    const auto weights = weights_of(seen, probability);
    for (std::size_t w = 0; w < weights.size(); ++w) {
      all.weights[w].push_back(seen.confidence * weights[w]);
    }
  }
  return all;
}

WeighedBlocks draw_replicate(const DepositBlocks& blocks, const VisibilityCorrection& correction,
                             Random& random) {
  WeighedBlocks all;
  for (const MeasuredBlock* block : blocks) {
    const DepositObservation& seen = *block->deposit;
    all.sizes.push_back(draw_block_sizes(*block, random));
    const double probability = correction.inclusion_probability(all.sizes.back().axes.I);
    const auto weights = weights_of(seen, probability);
    const bool is_block = random.uniform() < seen.confidence;
    const double found = draw_factor(1.0 - VisibilityCorrection::kMostFound, random);
    const double any = draw_factor(1.0 - probability, random);
    for (std::size_t w = 0; w < weights.size(); ++w) {
      const double chance = kSizeWeightings[w] == SizeWeighting::kCorrected ? any : found;
      all.weights[w].push_back(is_block ? chance * weights[w] : 0.0);
    }
  }
  return all;
}

/// Percentiles of all quantities by all weightings.
std::vector<double> percentiles_of(const WeighedBlocks& blocks) {
  std::vector<double> all;
  for (std::size_t w = 0; w < kSizeWeightings.size(); ++w) {
    for (std::size_t q = 0; q < kWeightedQuantities.size(); ++q) {
      std::vector<double> sizes;
      for (const BlockSizes& one : blocks.sizes) sizes.push_back(quantity_of(one, q));
      const std::vector<double> percentiles =
          weighted_percentiles(sizes, blocks.weights[w], kWeightedPercentiles);
      all.insert(all.end(), percentiles.begin(), percentiles.end());
    }
  }
  return all;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

/// Fractions of the classes of a scheme by one weighting.
std::vector<double> fractions_of(const WeighedBlocks& blocks, std::size_t weighting,
                                 const std::string& scheme, const SchemeOptions& limits) {
  const std::vector<std::string>& names = class_names(scheme);
  std::vector<double> sums(names.size(), 0.0);
  for (std::size_t i = 0; i < blocks.sizes.size(); ++i) {
    const std::string name = shape_class(scheme, blocks.sizes[i].axes, limits);
    const auto k = std::find(names.begin(), names.end(), name) - names.begin();
    sums[static_cast<std::size_t>(k)] += blocks.weights[weighting][i];
  }
  const double total = sum_of(blocks.weights[weighting]);
  for (double& sum : sums) sum = total > 0.0 ? sum / total : 0.0;
  return sums;
}

/// Makes an estimate whose interval is that of the replicates, relative to their median.
EstimatedValue estimate_from(double value, std::vector<double> replicates) {
  std::sort(replicates.begin(), replicates.end());
  const double median = quantile(replicates, 0.5);
  const Interval interval = percentile_interval(std::move(replicates));
  if (!(median > 0.0)) return {value, interval};
  return {value, {value * interval.low / median, value * interval.high / median}};
}

/// Returns entry `k` of each list.
std::vector<double> entries_of(const std::vector<std::vector<double>>& lists, std::size_t k) {
  std::vector<double> entries;
  for (const std::vector<double>& list : lists) entries.push_back(list[k]);
  return entries;
}

/// Estimates proportions that sum to one: the means of the replicates. The interval is Wilson's for
/// the number of independent blocks with `kVarianceFactor` times the variance of the replicates.
/// @param replicates  proportions in each replicate
/// @param most_trials  number of blocks that the weights are worth
std::vector<EstimatedValue> estimate_proportions(const std::vector<std::vector<double>>& replicates,
                                                 double most_trials) {
  std::vector<EstimatedValue> proportions(replicates.front().size());
  for (std::size_t k = 0; k < proportions.size(); ++k) {
    const std::vector<double> values = entries_of(replicates, k);
    const double p = arithmetic_mean(values);
    double variance = 0.0;
    for (const double value : values) variance += (value - p) * (value - p);
    variance *= kVarianceFactor / static_cast<double>(values.size());
    double trials = most_trials;
    if (variance > 0.0) trials = std::min(trials, p * (1.0 - p) / variance);
    proportions[k] = {p, wilson_interval_of_proportion(p, std::max(trials, 1.0))};
  }
  return proportions;
}

/// Number of equally weighted blocks with the sampling variance of the weights.
/// @param unseen  mean fraction of the bodies that are not found
double effective_trials(const std::vector<double>& weights, double unseen) {
  double squares = 0.0;
  for (const double weight : weights) squares += weight * weight;
  const double sum = sum_of(weights);
  return squares > 0.0 ? sum * sum / squares / std::max(unseen, 1e-3) : 1.0;
}

constexpr auto kFound = static_cast<std::size_t>(SizeWeighting::kNumber);
constexpr auto kCorrected = static_cast<std::size_t>(SizeWeighting::kCorrected);

using Replicates = std::vector<WeighedBlocks>;

/// Computes a value of each replicate.
template <class Compute>
auto values_of(const Replicates& replicates, unsigned threads, const Compute& compute) {
  std::vector<decltype(compute(replicates.front()))> values(replicates.size());
  parallel_for(replicates.size(), threads,
               [&](std::size_t r) { values[r] = compute(replicates[r]); });
  return values;
}

std::array<WeightedSizes, kSizeWeightings.size()> estimate_sizes(const WeighedBlocks& medians,
                                                                 const Replicates& replicates,
                                                                 unsigned threads) {
  const std::vector<double> values = percentiles_of(medians);
  const auto drawn = values_of(replicates, threads, percentiles_of);
  std::array<WeightedSizes, kSizeWeightings.size()> all;
  std::size_t k = 0;
  for (std::size_t w = 0; w < kSizeWeightings.size(); ++w) {
    all[w].weighting = kSizeWeightings[w];
    for (auto& percentiles : all[w].percentiles) {
      for (EstimatedValue& percentile : percentiles) {
        percentile = estimate_from(values[k], entries_of(drawn, k));
        ++k;
      }
    }
  }
  return all;
}

/// Numbers of equally weighted blocks that the found and the corrected weights are worth.
struct EffectiveTrials {
  double found = 1.0, corrected = 1.0;
};

CorrectedSchemeFractions estimate_fractions(const std::string& scheme, const SchemeOptions& limits,
                                            const Replicates& replicates, unsigned threads,
                                            const EffectiveTrials& trials) {
  const auto proportions_by = [&](std::size_t weighting, double most_trials) {
    const auto fractions = [&](const WeighedBlocks& one) {
      return fractions_of(one, weighting, scheme, limits);
    };
    return estimate_proportions(values_of(replicates, threads, fractions), most_trials);
  };
  const std::vector<EstimatedValue> found = proportions_by(kFound, trials.found);
  const std::vector<EstimatedValue> corrected = proportions_by(kCorrected, trials.corrected);
  const std::vector<std::string>& names = class_names(scheme);
  CorrectedSchemeFractions result{scheme, {}};
  for (std::size_t k = 0; k < names.size(); ++k) {
    result.fractions.push_back({names[k], found[k], corrected[k]});
  }
  return result;
}

}  // namespace

std::string name_of(SizeWeighting weighting) {
  switch (weighting) {
    case SizeWeighting::kNumber:
      return "number";
    case SizeWeighting::kArea:
      return "area";
    case SizeWeighting::kGrid:
      return "grid";
    case SizeWeighting::kCorrected:
      return "corrected";
  }
  return {};
}

std::optional<ScannedDepositSummary> summarise_scanned_deposit(const Population& population,
                                                               const PopulationOptions& options,
                                                               unsigned threads) {
  DepositBlocks blocks;
  std::vector<MeasuredBlock> observed;
  for (const MeasuredBlock& block : population.blocks) {
    if (!block.deposit || block.unscaled) continue;
    blocks.push_back(&block);
    observed.push_back(block);
  }
  if (blocks.size() < kLeastCorrectedBlocks) return std::nullopt;
  ScannedDepositSummary summary;
  summary.blocks = blocks.size();
  for (const MeasuredBlock* block : blocks) summary.expected_blocks += block->deposit->confidence;
  if (!(summary.expected_blocks > 0.0)) return std::nullopt;
  summary.correction = fit_visibility_correction(observed, options.seed, kReplicates);

  const WeighedBlocks medians = weigh_medians(blocks, summary.correction);
  Replicates replicates(kReplicates);
  std::vector<std::uint64_t> seeds;
  for (Random random(options.seed); seeds.size() < kReplicates;)
    seeds.push_back(random.next_bits());
  parallel_for(kReplicates, threads, [&](std::size_t r) {
    Random random(seeds[r]);
    replicates[r] = draw_replicate(blocks, summary.correction.with_draw(r), random);
  });
  const auto count_of = [](const WeighedBlocks& one) { return sum_of(one.weights[kCorrected]); };
  summary.corrected_blocks =
      estimate_from(count_of(medians), values_of(replicates, threads, count_of));
  summary.sizes = estimate_sizes(medians, replicates, threads);
  const double unseen = 1.0 - summary.expected_blocks / summary.corrected_blocks.value;
  const EffectiveTrials trials = {
      effective_trials(medians.weights[kFound], 1.0 - VisibilityCorrection::kMostFound),
      effective_trials(medians.weights[kCorrected], unseen)};
  for (const std::string& scheme : options.selected_schemes()) {
    summary.schemes.push_back(
        estimate_fractions(scheme, options.limits, replicates, threads, trials));
  }
  summary.long_axes = summarise_long_axes(observed);
  return summary;
}

}  // namespace clast
