#include "library/block_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

/// Parents among which a body's is drawn.
constexpr std::size_t kNearest = 3;
constexpr std::size_t kMinDigits = 4;

/// Stretch that a block needs: distance of the logarithms of its ratios.
double stretch_between(const BoxRatios& a, const BoxRatios& b) {
  return std::hypot(std::log(a.i_l / b.i_l), std::log(a.s_l / b.s_l));
}

const Block& nearby_parent(std::span<const Block* const> parents, const BoxRatios& form,
                           Random& random) {
  std::vector<std::size_t> order(parents.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return stretch_between(box_ratios(parents[a]->box), form) <
           stretch_between(box_ratios(parents[b]->box), form);
  });
  return *parents[order[random.uniform_index(std::min(kNearest, order.size()))]];
}

std::string numbered(const std::string& prefix, std::size_t number, std::size_t count) {
  const std::string digits = std::to_string(number);
  const std::size_t width = std::max(kMinDigits, std::to_string(count).size());
  return prefix + std::string(width - digits.size(), '0') + digits;
}

}  // namespace

std::vector<VariationRequest> combine_variations(std::span<const Block* const> parents,
                                                 std::span<const Variation> variations) {
  std::vector<VariationRequest> requests;
  for (const Block* parent : parents) {
    for (const Variation& variation : variations) {
      requests.push_back({parent, variation, parent->id + "_" + variation_label(variation)});
    }
  }
  return requests;
}

VariedBlockSeries make_variation_series(std::span<const VariationRequest> requests,
                                        const BlockSource& source,
                                        const VariationSeriesOptions& options) {
  options.variation.check();
  std::vector<std::optional<Block>> made(requests.size());
  std::vector<std::string> reasons(requests.size());
  std::size_t done = 0;
  std::mutex one_at_a_time;
  parallel_for(requests.size(), options.threads, [&](std::size_t i) {
    const VariationRequest& request = requests[i];
    try {
      made[i] =
          vary_block(request.id, *request.parent, request.variation, source, options.variation);
    } catch (const Error& error) {
      reasons[i] = error.what();  // one body never costs the series
    }
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (options.progress) options.progress({.done = done, .total = requests.size()});
  });
  VariedBlockSeries series;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i]) {
      series.blocks.push_back(*std::move(made[i]));
    } else {
      series.failures.push_back(reasons[i]);
    }
  }
  return series;
}

SampledVariationRequests sample_variation_requests(std::span<const Block* const> parents,
                                                   std::span<const BlockForm> population,
                                                   std::size_t count, std::uint64_t seed,
                                                   const std::string& prefix) {
  if (parents.empty()) throw InputError("there is no block from which to make bodies");
  const FormCopula copula(population);
  Random random(seed);
  SampledVariationRequests series;
  std::vector<BlockForm> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    drawn.push_back(copula.sample(random));
    const Axes& axes = drawn.back().axes;
    const BoxRatios form = {axes.I / axes.L, axes.S / axes.L};
    const Block& parent = nearby_parent(parents, form, random);
    series.requests.push_back({&parent, SampledFormVariation{form, axes.L, drawn.back().convexity},
                               numbered(prefix, i + 1, count)});
  }
  series.fit = copula.assess_fit(drawn);
  return series;
}

std::vector<BlockForm> block_forms(std::span<const Block* const> blocks) {
  std::vector<BlockForm> population;
  for (const Block* block : blocks) {
    population.push_back({block->axes(), convexity(block->body, block->mass.volume)});
  }
  return population;
}

}  // namespace clast
