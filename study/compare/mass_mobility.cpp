#include "study/compare/mass_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "study/compare/realisation_deposits.hpp"

namespace clast {
namespace {

/// Runouts by realisation, or by release point, with what else is compared.
struct Runouts {
  std::map<std::uint32_t, std::vector<double>> by_cluster;
  std::vector<double> masses;
  std::vector<double> start_x, start_y;  ///< map

  Vec2 mean_start() const {
    return {summarise_sample(start_x).mean, summarise_sample(start_y).mean};
  }
};

std::set<std::string> library_blocks(const Comparison& comparison, std::uint32_t file) {
  std::set<std::string> blocks;
  for (const BlockSummary& block : comparison.results[file].blocks) {
    blocks.insert(block.library_block());
  }
  return blocks;
}

/// Returns the runouts of runs of a file that came to rest, for these library blocks and class.
/// @param garcia  empty: all classes
Runouts runouts_of(const Comparison& comparison, std::uint32_t file,
                   const std::set<std::string>& blocks, const std::string& garcia) {
  const CampaignResults& results = comparison.results[file];
  Runouts runouts;
  for (const RunRow& row : comparison.rows) {
    if (row.file != file || !blocks.contains(row.block->library_block())) continue;
    if (!garcia.empty() && row.block->garcia != garcia) continue;
    const bool at_rest = results.persistent_blocks
                             ? is_in_deposit(comparison, row)
                             : row.record->result.stop_reason == StopReason::kRest;
    if (!at_rest) continue;
    runouts.by_cluster[cluster_index_of_run(results, *row.record)].push_back(row.runout);
    runouts.masses.push_back(row.block->mass);
    runouts.start_x.push_back(row.start.x());
    runouts.start_y.push_back(row.start.y());
  }
  return runouts;
}

/// Summarises a value of each cluster.
template <class Value>
SampleSummary over_clusters(const Runouts& runouts, const Value& value) {
  std::vector<double> values;
  for (const auto& [cluster, of_cluster] : runouts.by_cluster) values.push_back(value(of_cluster));
  return summarise_sample(values);
}

std::vector<double> joined_values(const Runouts& runouts) {
  std::vector<double> all;
  for (const auto& [cluster, values] : runouts.by_cluster) {
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

std::optional<DepositMobility> mobility_of(const Comparison& comparison, std::uint32_t file,
                                           std::uint32_t alone, const std::string& garcia) {
  std::set<std::string> both;
  const std::set<std::string> blocks = library_blocks(comparison, file);
  for (const std::string& block : library_blocks(comparison, alone)) {
    if (blocks.contains(block)) both.insert(block);
  }
  const Runouts together = runouts_of(comparison, file, both, garcia);
  const Runouts single = runouts_of(comparison, alone, both, garcia);
  if (together.masses.empty() || single.masses.empty()) return std::nullopt;
  const auto mean = [](const std::vector<double>& values) { return summarise_sample(values).mean; };
  const std::vector<double> runs = joined_values(single);
  DepositMobility found;
  found.file = file;
  found.single_block_file = alone;
  found.group = garcia.empty() ? "all" : "class " + garcia;
  found.blocks = joined_values(together).size();
  found.runs = runs.size();
  found.together_runout = over_clusters(together, mean);
  const bool one_point = single.by_cluster.size() == 1;
  found.alone_runout = one_point ? summarise_sample(runs) : over_clusters(single, mean);
  found.difference = welch_difference(found.together_runout, found.alone_runout);
  found.together_toe = over_clusters(together, [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  });
  found.alone_toe = expected_maximum(
      runs, static_cast<double>(found.blocks) / static_cast<double>(together.by_cluster.size()));
  found.start_distance = (together.mean_start() - single.mean_start()).norm();
  found.mass_ratio = summarise_sample(together.masses).mean / summarise_sample(single.masses).mean;
  return found;
}

}  // namespace

double expected_maximum(std::span<const double> values, double count) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  double sum = 0.0, below = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double up_to = std::pow(static_cast<double>(i + 1) / n, count);
    sum += sorted[i] * (up_to - below);
    below = up_to;
  }
  return sum;
}

std::vector<DepositMobility> compute_mass_mobility(const Comparison& comparison) {
  std::vector<DepositMobility> all;
  const auto count = static_cast<std::uint32_t>(comparison.results.size());
  for (std::uint32_t file = 0; file < count; ++file) {
    if (!comparison.results[file].persistent_blocks) continue;
    for (std::uint32_t alone = 0; alone < count; ++alone) {
      if (comparison.results[alone].persistent_blocks) continue;
      for (const char* garcia : {"", "compact", "elongated"}) {
        if (std::optional<DepositMobility> found = mobility_of(comparison, file, alone, garcia)) {
          all.push_back(std::move(*found));
        }
      }
    }
  }
  return all;
}

}  // namespace clast
