#include "library/deposit_observations.hpp"

#include <map>
#include <numeric>

#include "classify/visibility_correction.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"
#include "mesh/plan_cover.hpp"

namespace clast {
namespace {

Axes axes_of(const Vec3& sides) { return {sides[0], sides[1], sides[2]}; }

DepositObservation observation_of(const Block& block, const PlanCover& cover) {
  const SizeIntervals& intervals = *block.volume_bracket->intervals;
  DepositObservation seen;
  seen.lower_axes = axes_of(intervals.sides.lower);
  seen.upper_axes = axes_of(intervals.sides.upper);
  seen.volume = block.mass.volume;
  seen.lower_volume = intervals.lower_volume;
  seen.upper_volume = intervals.upper_volume;
  seen.long_axis = block.box.axes.col(0);
  seen.points = block.deposit->points;
  seen.spacing = block.deposit->spacing;
  seen.visible_fraction = block.deposit->visible_fraction;
  seen.confidence = block.deposit->confidence;
  seen.plan_area = cover.area;
  seen.exposed_area = cover.exposed;
  return seen;
}

bool is_observed(const Block& block) {
  return block.deposit && block.volume_bracket && block.volume_bracket->intervals;
}

}  // namespace

std::vector<std::optional<DepositObservation>> make_deposit_observations(
    std::span<const Block> blocks) {
  std::map<std::string, std::vector<std::size_t>> scans;  // by the digest of their file
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (is_observed(blocks[i])) scans[blocks[i].source.sha256].push_back(i);
  }
  std::vector<std::optional<DepositObservation>> observations(blocks.size());
  for (const auto& [digest, members] : scans) {
    std::vector<const TriangleMesh*> bodies;
    for (const std::size_t i : members) bodies.push_back(&blocks[i].surface);
    const std::vector<PlanCover> covers = measure_plan_cover(bodies);
    for (std::size_t k = 0; k < members.size(); ++k) {
      observations[members[k]] = observation_of(blocks[members[k]], covers[k]);
    }
  }
  return observations;
}

std::size_t choose_by_weight(std::span<const double> weights, Random& random) {
  double left = random.uniform() * std::accumulate(weights.begin(), weights.end(), 0.0);
  std::size_t index = 0;
  while (index + 1 < weights.size() && left >= weights[index]) left -= weights[index++];
  return index;
}

std::optional<WeightedDeposit> weigh_deposit(std::span<const Block* const> blocks) {
  WeightedDeposit deposit;
  for (const Block* block : blocks) {
    if (!is_observed(*block) || is_unscaled(*block)) return std::nullopt;
    deposit.blocks.push_back(make_measured_block(block->id, block->axes(), block->mass.mass));
    deposit.blocks.back().deposit = observation_of(*block, {});
  }
  if (blocks.size() < kLeastCorrectedBlocks) return std::nullopt;
  constexpr std::uint64_t kSeed = 1;  // as `PopulationOptions::seed`
  const VisibilityCorrection correction = fit_visibility_correction(deposit.blocks, kSeed);
  for (const MeasuredBlock& block : deposit.blocks) {
    deposit.weights.push_back(block.deposit->confidence /
                              correction.inclusion_probability(median_block_sizes(block).axes.I));
  }
  return deposit;
}

std::string describe_weighted_deposit(const WeightedDeposit& deposit) {
  const double all = std::accumulate(deposit.weights.begin(), deposit.weights.end(), 0.0);
  return "bodies are drawn from a scanned deposit: its " +
         format_count(deposit.blocks.size(), "found block") + " stand for about " +
         format_significant(all, 3) +
         ", with those that its surface does not show; these have the forms of found blocks of "
         "nearly their size";
}

}  // namespace clast
