#include "classify/population.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

struct MassSums {
  double all = 0.0;
  double squares = 0.0;
};

/// @param of_class  of the blocks of one class
void set_mass_share(ClassFraction& share, const MassSums& of_class, const MassSums& whole) {
  share.mass = of_class.all;
  if (whole.all == 0.0) return;
  const double p = std::min(1.0, of_class.all / whole.all);
  double trials = whole.all * whole.all / whole.squares;
  // p is a ratio of sums: its residuals are m (1 - p) in the class and -m p outside.
  const double outside = std::max(0.0, whole.squares - of_class.squares);
  const double variance =
      (of_class.squares * (1.0 - p) * (1.0 - p) + outside * p * p) / (whole.all * whole.all);
  if (variance > 0.0) trials = std::min(trials, p * (1.0 - p) / variance);
  const Interval interval = wilson_interval_of_proportion(p, std::max(trials, 1.0));
  share.mass_fraction = p;
  share.mass_low = interval.low;
  share.mass_high = interval.high;
}

}  // namespace

std::vector<Axes> axes_for_ratios(const Population& population) {
  std::vector<Axes> result;
  result.reserve(population.blocks.size());
  for (const MeasuredBlock& block : population.blocks) result.push_back(block.axes_in_table_unit);
  return result;
}

std::vector<double> block_masses(const Population& population) {
  std::vector<double> result;
  result.reserve(population.blocks.size());
  for (const MeasuredBlock& block : population.blocks) result.push_back(block.mass.value_or(0.0));
  return result;
}

std::vector<ClassFraction> class_fractions(std::span<const Axes> blocks, const std::string& scheme,
                                           const SchemeOptions& options,
                                           std::span<const double> weights) {
  assert(weights.empty() || weights.size() == blocks.size());
  const std::vector<std::string>& names = class_names(scheme);
  std::vector<ClassFraction> shares(names.size());
  std::vector<MassSums> sums(names.size());
  MassSums whole;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::string name = shape_class(scheme, blocks[i], options);
    const auto k =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    assert(k < names.size());
    ++shares[k].count;
    if (weights.empty()) continue;
    for (MassSums* sum : {&sums[k], &whole}) {
      sum->all += weights[i];
      sum->squares += weights[i] * weights[i];
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    ClassFraction& share = shares[k];
    share.name = names[k];
    const Interval interval = wilson_interval(share.count, blocks.size());
    if (!blocks.empty()) {
      share.fraction = static_cast<double>(share.count) / static_cast<double>(blocks.size());
    }
    share.low = interval.low;
    share.high = interval.high;
    set_mass_share(share, sums[k], whole);
  }
  return shares;
}

double c40_index(std::span<const Axes> blocks) {
  const auto slabs = std::count_if(blocks.begin(), blocks.end(), [](const Axes& axes) {
    return axes.S / axes.L <= 0.4 + 1e-12;  // decimals on the limit are on it
  });
  return static_cast<double>(slabs) / static_cast<double>(blocks.size());
}

}  // namespace clast
