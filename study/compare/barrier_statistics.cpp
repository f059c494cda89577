#include "study/compare/barrier_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace clast {
namespace {

constexpr std::size_t kPassageCurvePoints = 241;

double mass_of(const BlockCrossing& passage) { return passage.mass; }
double energy_of(const BlockCrossing& passage) { return passage.energy; }
double one(const BlockCrossing&) { return 1.0; }

/// Blocks that were released, by file and realisation of those that stay.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> released(
    const Comparison& comparison) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> blocks;
  for (const RunRow& row : comparison.rows) {
    const CampaignResults& results = comparison.results[row.file];
    if (results.persistent_blocks) ++blocks[{row.file, cluster_index_of_run(results, *row.record)}];
  }
  return blocks;
}

void find_peaks(RealisationCrossings& found) {
  std::stable_sort(found.passages.begin(), found.passages.end(),
                   [](const BlockCrossing& a, const BlockCrossing& b) { return a.time < b.time; });
  found.max_blocks_in_window = find_window_maximum(found.passages, kPassageWindow, one);
  found.max_mass_in_window = find_window_maximum(found.passages, kPassageWindow, mass_of);
  found.max_energy_in_window = find_window_maximum(found.passages, kPassageWindow, energy_of);
  for (const BlockCrossing& passage : found.passages) {
    found.largest_energy = std::max(found.largest_energy, passage.energy);
  }
}

}  // namespace

WindowMaximum find_window_maximum(const std::vector<BlockCrossing>& passages, double window,
                                  const CrossingValue& value) {
  WindowMaximum peak;
  // Each window is added up anew: what is subtracted again leaves rounding behind.
  for (std::size_t first = 0; first < passages.size(); ++first) {
    double sum = 0.0;
    for (std::size_t i = first;
         i < passages.size() && passages[i].time <= passages[first].time + window; ++i) {
      sum += value(passages[i]);
    }
    if (sum > peak.value) peak = {sum, passages[first].time};
  }
  return peak;
}

double RealisationCrossings::sum(const CrossingValue& value) const {
  double sum = 0.0;
  for (const BlockCrossing& passage : passages) sum += value(passage);
  return sum;
}

std::vector<RealisationCrossings> collect_barrier_crossings(const Comparison& comparison) {
  std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, RealisationCrossings> found;
  const auto blocks = released(comparison);
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    for (const auto& [key, count] : blocks) {
      if (!comparison.lines[line].is_in(key.first)) continue;
      RealisationCrossings& of_realisation = found[{line, key.first, key.second}];
      of_realisation.line = line;
      of_realisation.file = key.first;
      of_realisation.realisation = key.second;
      of_realisation.blocks = count;
    }
  }
  for (const BarrierCrossing& crossing : comparison.crossings) {
    if (!crossing.counted) continue;
    const RunRow& row = comparison.rows[crossing.row];
    const CampaignResults& results = comparison.results[row.file];
    const PersistentBlockRecord* stay = results.find_persistent_block(row.record->run);
    if (!results.persistent_blocks || !stay) continue;
    // Times of blocks released at once count from the first release, others from their own.
    const double begun = results.persistent_blocks->at_once ? 0.0 : stay->released_at;
    found[{crossing.barrier, row.file, cluster_index_of_run(results, *row.record)}]
        .passages.push_back(
            {crossing.row, begun + crossing.crossing->time, row.block->mass, row.block->volume,
             crossing.crossing->translational_energy + crossing.crossing->rotational_energy});
  }
  std::vector<RealisationCrossings> all;
  for (auto& [key, of_realisation] : found) {
    find_peaks(of_realisation);
    all.push_back(std::move(of_realisation));
  }
  return all;
}

RealisationCurve passage_curve(const std::vector<const RealisationCrossings*>& realisations,
                               const CrossingValue& value) {
  RealisationCurve curve;
  double last = -INFINITY;
  for (const RealisationCrossings* one : realisations) {
    if (!one->passages.empty()) last = std::max(last, one->last());
  }
  if (!std::isfinite(last)) return curve;
  std::vector<double> sums(realisations.size(), 0.0);
  std::vector<std::size_t> next(realisations.size(), 0);
  for (std::size_t i = 0; i < kPassageCurvePoints; ++i) {
    // The last point is the last passage itself, whatever the steps add up to.
    const double time =
        i + 1 == kPassageCurvePoints
            ? last
            : last * static_cast<double>(i) / static_cast<double>(kPassageCurvePoints - 1);
    for (std::size_t k = 0; k < realisations.size(); ++k) {
      const std::vector<BlockCrossing>& passages = realisations[k]->passages;
      for (; next[k] < passages.size() && passages[next[k]].time <= time; ++next[k]) {
        sums[k] += value(passages[next[k]]);
      }
    }
    curve.time.push_back(time);
    curve.mean.push_back(summarise_sample(sums).mean);
    curve.minimum.push_back(*std::min_element(sums.begin(), sums.end()));
    curve.maximum.push_back(*std::max_element(sums.begin(), sums.end()));
  }
  return curve;
}

}  // namespace clast
