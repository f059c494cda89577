#include "study/compare/ground_draws.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "study/compare/ensemble_effects.hpp"

namespace clast {

std::vector<GroundDrawRows> group_rows_by_draw(const Comparison& comparison,
                                               const std::vector<std::size_t>& rows) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> by_draw;
  bool drawn = false;
  for (const std::size_t row : rows) {
    const RunRow& run = comparison.rows[row];
    const CampaignResults& results = comparison.results[run.file];
    drawn = drawn || count_ensemble_members(results) > 1;
    const std::uint32_t member =
        results.ground_sets.empty() ? 0 : results.ground_sets[run.record->ground_set].member;
    by_draw[{run.file, member}].push_back(row);
  }
  std::vector<GroundDrawRows> draws;
  if (!drawn) return draws;
  for (auto& [draw, of_draw] : by_draw) {
    draws.push_back({draw.first, draw.second, std::move(of_draw)});
  }
  return draws;
}

Interval compute_range_over_draws(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  if (values.size() < kMinDrawsForPercentiles) return {values.front(), values.back()};
  return {quantile(values, 0.05), quantile(values, 0.95)};
}

}  // namespace clast
