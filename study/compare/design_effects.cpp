#include "study/compare/design_effects.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "core/number_text.hpp"
#include "core/statistics/unbalanced_variance.hpp"
#include "study/compare/detail/run_outcomes.hpp"

namespace clast {

using namespace study_detail;
namespace {

constexpr double kSameTurn = 1e-6;  ///< rad

/// The level of every run of a file, by one factor.
struct FactorLevels {
  std::string name;
  std::vector<std::size_t> of_run;
  std::size_t count = 0;
};

/// Levels numbered in the order of their keys.
template <class Key>
FactorLevels levels_by(const std::string& name, const std::vector<const RunRow*>& rows,
                       const std::function<Key(const RunRow&)>& key) {
  std::map<Key, std::size_t> numbers;
  for (const RunRow* row : rows) numbers.emplace(key(*row), 0);
  std::size_t next = 0;
  for (auto& [value, number] : numbers) number = next++;
  FactorLevels levels{name, {}, numbers.size()};
  for (const RunRow* row : rows) levels.of_run.push_back(numbers.at(key(*row)));
  return levels;
}

/// Form and mass where they are crossed, else the block.
std::vector<FactorLevels> block_factors(const std::vector<const RunRow*>& rows) {
  const std::vector<double> masses = find_distinct_masses(rows);
  const FactorLevels form = levels_by<std::string>(
      "form", rows, [](const RunRow& row) { return row.block->library_block(); });
  const FactorLevels mass = levels_by<std::size_t>(
      "mass", rows, [&](const RunRow& row) { return find_mass_level(masses, row.block->mass); });
  const FactorLevels block =
      levels_by<std::uint32_t>("block", rows, [](const RunRow& row) { return row.record->block; });
  std::set<std::pair<std::size_t, std::size_t>> met;
  for (std::size_t i = 0; i < rows.size(); ++i) met.emplace(form.of_run[i], mass.of_run[i]);
  const std::size_t combinations = form.count * mass.count;
  const bool crossed = met.size() == combinations && block.count == combinations;
  return crossed ? std::vector{form, mass} : std::vector{block};
}

std::vector<FactorLevels> factors_of(const std::vector<const RunRow*>& rows,
                                     const CampaignResults& results) {
  std::vector<FactorLevels> factors = block_factors(rows);
  factors.push_back(levels_by<std::uint32_t>(
      "orientation", rows, [](const RunRow& row) { return row.record->orientation; }));
  factors.push_back(levels_by<std::uint32_t>("release point", rows,
                                             [](const RunRow& row) { return row.record->point; }));
  factors.push_back(levels_by<std::uint32_t>("ground", rows, [&](const RunRow& row) {
    return results.ground_sets.empty() ? 0u : results.ground_sets[row.record->ground_set].member;
  }));
  std::erase_if(factors, [](const FactorLevels& factor) { return factor.count < 2; });
  return factors;
}

/// Returns the index of each run in the full design, the last factor varying fastest; empty if a
/// combination is missing or repeated.
std::vector<std::size_t> places_in(const std::vector<FactorLevels>& factors, std::size_t runs) {
  std::size_t combinations = 1;
  for (const FactorLevels& factor : factors) {
    if (combinations > runs) return {};
    combinations *= factor.count;
  }
  if (combinations != runs) return {};
  std::vector<std::size_t> places;
  std::vector<bool> taken(runs, false);
  for (std::size_t i = 0; i < runs; ++i) {
    std::size_t place = 0;
    for (const FactorLevels& factor : factors) place = place * factor.count + factor.of_run[i];
    if (taken[place]) return {};
    taken[place] = true;
    places.push_back(place);
  }
  return places;
}

/// True if runs of one block and orientation number start with different orientations, which were
/// drawn for each point. With a single point, only the campaign shows this: blocks may differ,
/// because a file of orientations rotates scans, not principal axes.
bool has_fresh_orientations(const std::vector<const RunRow*>& rows,
                            const CampaignResults& results) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Quat> known;
  std::map<std::uint32_t, Quat> of_number;
  bool blocks_differ = false;
  for (const RunRow* row : rows) {
    const RunRecord& run = *row->record;
    const Quat& turn = run.start.orientation;
    const auto [at, fresh] = known.try_emplace({run.block, run.orientation}, turn);
    if (at->second.angularDistance(turn) > kSameTurn) return true;
    const auto first = of_number.try_emplace(run.orientation, turn).first;
    blocks_differ = blocks_differ || first->second.angularDistance(turn) > kSameTurn;
  }
  return blocks_differ && results.release_points.size() == 1 &&
         results.campaign_text.find("fresh") != std::string::npos;
}

/// Why the design is not full.
std::string gap_of(const std::vector<FactorLevels>& factors, std::size_t runs) {
  std::string text;
  std::size_t combinations = 1;
  for (const FactorLevels& factor : factors) {
    text += (text.empty() ? "" : ", ") + factor.name + " " + std::to_string(factor.count);
    combinations *= factor.count;
  }
  return format_count(runs, "run") + " do not contain every combination exactly once (" + text +
         ": " + std::to_string(combinations) + " combinations)";
}

/// Shares of the outcomes that differ, by what a function makes of all of them.
template <class Shares>
std::vector<OutcomeEffects> outcomes_with(const std::vector<RunOutcome>& outcomes,
                                          const Shares& shares) {
  std::vector<const RunOutcome*> differing;
  for (const RunOutcome& outcome : outcomes) {
    const auto [minimum, maximum] =
        std::minmax_element(outcome.values.begin(), outcome.values.end());
    if (*minimum < *maximum) differing.push_back(&outcome);  // else there is nothing to explain
  }
  std::vector<std::vector<double>> values;
  for (const RunOutcome* outcome : differing) values.push_back(outcome->values);
  const std::vector<VarianceDecomposition> found = shares(values);
  std::vector<OutcomeEffects> effects;
  for (std::size_t i = 0; i < differing.size(); ++i) {
    const SampleSummary summary = summarise_sample(values[i]);
    effects.push_back(
        {differing[i]->name, differing[i]->unit, summary.mean, summary.std, found[i]});
  }
  return effects;
}

std::vector<VarianceDecomposition> shares_of_design(
    const std::vector<std::vector<double>>& outcomes, const std::vector<std::size_t>& places,
    const std::vector<FactorLevels>& factors) {
  std::vector<std::size_t> levels;
  for (const FactorLevels& factor : factors) levels.push_back(factor.count);
  std::vector<VarianceDecomposition> shares;
  for (const std::vector<double>& outcome : outcomes) {
    std::vector<double> values(outcome.size());
    for (std::size_t i = 0; i < outcome.size(); ++i) values[places[i]] = outcome[i];
    shares.push_back(decompose_variance(values, levels));
  }
  return shares;
}

std::vector<VarianceDecomposition> shares_of_model(const std::vector<std::vector<double>>& outcomes,
                                                   const std::vector<FactorLevels>& factors) {
  std::vector<std::vector<std::uint32_t>> levels;
  for (const FactorLevels& factor : factors) {
    levels.emplace_back(factor.of_run.begin(), factor.of_run.end());
  }
  return decompose_unbalanced_variance(outcomes, levels);
}

DesignEffects effects_of(const Comparison& comparison, std::uint32_t file) {
  DesignEffects effects;
  effects.file = file;
  const CampaignResults& results = comparison.results[file];
  if (results.persistent_blocks) {
    effects.refusal_reason = "its blocks are persistent, so runs depend on each other";
    return effects;
  }
  const std::vector<const RunRow*> rows = select_rows_of_file(comparison, file);
  std::vector<FactorLevels> factors = factors_of(rows, results);
  const bool fresh = has_fresh_orientations(rows, results);
  if (fresh) {
    std::erase_if(factors, [](const FactorLevels& factor) { return factor.name == "orientation"; });
  }
  if (factors.empty()) {
    effects.refusal_reason =
        fresh ? "its orientations are drawn for each block and release point, so "
                "none occurs twice, and nothing else differs between runs"
              : "its runs do not differ in anything";
    return effects;
  }
  for (const FactorLevels& factor : factors) effects.factors.push_back({factor.name, factor.count});
  const std::vector<RunOutcome> outcomes = collect_run_outcomes(comparison, file, rows);
  const std::vector<std::size_t> places = places_in(factors, rows.size());
  if (fresh) {
    effects.estimated =
        "orientations are drawn for each block and release point, so their effect is part of the "
        "interactions";
  } else if (places.empty()) {
    effects.estimated = gap_of(factors, rows.size());
  }
  effects.outcomes = outcomes_with(outcomes, [&](const auto& values) {
    return effects.estimated.empty() ? shares_of_design(values, places, factors)
                                     : shares_of_model(values, factors);
  });
  return effects;
}

}  // namespace

std::vector<DesignEffects> compute_design_effects(const Comparison& comparison) {
  std::vector<DesignEffects> effects;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    effects.push_back(effects_of(comparison, file));
  }
  return effects;
}

}  // namespace clast
