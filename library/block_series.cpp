#include "library/block_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

/// Parents among which a body's is drawn.
constexpr std::size_t kNearest = 3;
/// Blocks that are tried for a body.
constexpr std::size_t kMostTried = 10;
constexpr std::size_t kMinDigits = 4;

/// Stretch that a block needs: distance of the logarithms of its ratios.
double stretch_between(const BoxRatios& a, const BoxRatios& b) {
  return std::hypot(std::log(a.i_l / b.i_l), std::log(a.s_l / b.s_l));
}

/// Returns the blocks to try for a form: one of those with the nearest form, drawn at random, then
/// the others by distance.
std::vector<const Block*> nearby_parents(std::span<const Block* const> parents,
                                         const BoxRatios& form, Random& random) {
  std::vector<const Block*> order(parents.begin(), parents.end());
  std::stable_sort(order.begin(), order.end(), [&](const Block* a, const Block* b) {
    return stretch_between(box_ratios(a->box), form) < stretch_between(box_ratios(b->box), form);
  });
  const std::size_t drawn = random.uniform_index(std::min(kNearest, order.size()));
  const auto at = order.begin() + static_cast<std::ptrdiff_t>(drawn);
  std::rotate(order.begin(), at, at + 1);
  order.resize(std::min(kMostTried, order.size()));
  return order;
}

/// Makes the body of a request from its parent or, if that fails, from the first substitute from
/// which it can be made.
/// @throws Error  if no block can be used: the message of the parent
Block make_variation(const VariationRequest& request, const BlockSource& source,
                     const VariationOptions& options) {
  try {
    return vary_block(request.id, *request.parent, request.variation, source, options);
  } catch (const Error& error) {
    for (const Block* substitute : request.substitutes) {
      try {
        return vary_block(request.id, *substitute, request.variation, source, options);
      } catch (const Error&) {  // the next one is tried
      }
    }
    if (request.substitutes.empty()) throw;
    throw GeometryError(std::string(error.what()) + "; nor can it be made from " +
                        format_count(request.substitutes.size(), "other block"));
  }
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
    try {
      made[i] = make_variation(requests[i], source, options.variation);
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
    const std::vector<const Block*> tried = nearby_parents(parents, form, random);
    series.requests.push_back({tried.front(),
                               SampledFormVariation{form, axes.L, drawn.back().convexity},
                               numbered(prefix, i + 1, count),
                               {tried.begin() + 1, tried.end()}});
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
