#include "study/deposit_fabric.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/probability.hpp"
#include "core/random.hpp"
#include "core/sample_tests.hpp"

namespace clast {
namespace {

/// Any seed is good; a fixed one gives the same p every time.
constexpr std::uint64_t kFabricSeed = 20220310;
constexpr std::size_t kMostFabricDrawn = 20'000'000;  ///< numbers for one test
constexpr std::size_t kMostDraws = 9999, kFewestFabricDraws = 200;

using FabricBlocks = std::vector<const LyingBlock*>;
using BlockValue = std::function<double(const LyingBlock&)>;

std::size_t draws_of(std::size_t numbers) {
  return std::clamp(kMostFabricDrawn / std::max<std::size_t>(numbers, 1), kFewestFabricDraws,
                    kMostDraws);
}

/// The blocks of each realisation.
std::map<std::uint32_t, FabricBlocks> by_realisation(const FabricBlocks& blocks) {
  std::map<std::uint32_t, FabricBlocks> found;
  for (const LyingBlock* block : blocks) found[block->realisation].push_back(block);
  return found;
}

RealisationMean fabric_mean(const std::vector<double>& of_realisations, const Interval& possible) {
  RealisationMean mean;
  mean.summary = summarise(of_realisations);
  mean.interval = mean_interval(mean.summary, possible);
  return mean;
}

RealisationMean fabric_mean(const std::map<std::uint32_t, FabricBlocks>& realisations,
                            const BlockValue& value,
                            const Interval& possible = {-INFINITY, INFINITY}) {
  std::vector<double> means;
  for (const auto& [number, blocks] : realisations) {
    std::vector<double> values;
    for (const LyingBlock* block : blocks) {
      if (std::isfinite(value(*block))) values.push_back(value(*block));
    }
    if (!values.empty()) means.push_back(summarise(values).mean);
  }
  return fabric_mean(means, possible);
}

FabricGroup fabric_of(std::uint32_t file, const std::string& name, const FabricBlocks& blocks) {
  FabricGroup group;
  group.file = file;
  group.name = name;
  group.blocks = blocks.size();
  const std::map<std::uint32_t, FabricBlocks> realisations = by_realisation(blocks);
  group.realisations = realisations.size();
  group.along = fabric_mean(realisations, [](const LyingBlock& block) { return block.along; });
  group.ahead = fabric_mean(realisations, [](const LyingBlock& block) { return block.ahead; });
  group.aside = fabric_mean(
      realisations, [](const LyingBlock& block) { return std::abs(block.aside); }, {0.0, INFINITY});
  group.height = fabric_mean(realisations, [](const LyingBlock& block) { return block.height; });
  group.relative_height = fabric_mean(
      realisations, [](const LyingBlock& block) { return block.relative_height; }, {0.0, 1.0});
  ClusteredValues trends;
  std::vector<double> plunges;
  Mat3 sum = Mat3::Zero();
  std::uint32_t cluster = 0;
  for (const auto& [number, of_realisation] : realisations) {
    for (const LyingBlock* block : of_realisation) {
      trends.values.push_back(block->trend);
      trends.clusters.push_back(cluster);
      plunges.push_back(block->plunge);
      sum += block->long_axis * block->long_axis.transpose();
    }
    ++cluster;
  }
  group.trend = axial_mean(trends.values);
  if (realisations.size() > 1) group.rayleigh = rayleigh_p(group.trend);
  group.rayleigh_realisations =
      rayleigh_p_of_clusters(trends, cluster, kFabricSeed, draws_of(realisations.size()));
  group.plunge = summarise(plunges).mean;
  const Mat3 mean = sum / static_cast<double>(blocks.size());
  const Vec3 ascending = Eigen::SelfAdjointEigenSolver<Mat3>(mean).eigenvalues();
  group.eigenvalues = ascending.reverse();
  group.trends = std::move(trends.values);
  return group;
}

/// All blocks of a file, each class of both schemes, and thirds by size.
void append_fabric_groups(const Comparison& comparison, std::uint32_t file,
                          const FabricBlocks& blocks, std::vector<FabricGroup>& groups) {
  const bool several = comparison.results.size() > 1;
  for (const Group& group : comparison.groups) {
    if (group.file.has_value() != several || (group.file && group.file != file)) continue;
    const bool classes = group.kind == GroupKind::kGarcia || group.kind == GroupKind::kSneedFolk;
    if (group.kind != GroupKind::kAll && !classes) continue;
    FabricBlocks members;
    for (const LyingBlock* block : blocks) {
      if (std::binary_search(group.rows.begin(), group.rows.end(), block->row)) {
        members.push_back(block);
      }
    }
    const std::string name = group.kind == GroupKind::kAll      ? "all"
                             : group.kind == GroupKind::kGarcia ? "class " + group.key
                                                                : "sneed-folk " + group.key;
    if (!members.empty()) groups.push_back(fabric_of(file, name, members));
  }
  std::vector<double> volumes;
  for (const LyingBlock* block : blocks) {
    volumes.push_back(comparison.rows[block->row].block->volume);
  }
  std::sort(volumes.begin(), volumes.end());
  const double low = quantile(volumes, 1.0 / 3.0), high = quantile(volumes, 2.0 / 3.0);
  if (!(low < high)) return;  // too few sizes for thirds
  FabricBlocks thirds[3];
  for (const LyingBlock* block : blocks) {
    const double volume = comparison.rows[block->row].block->volume;
    thirds[volume <= low ? 0 : volume <= high ? 1 : 2].push_back(block);
  }
  const char* names[] = {"smallest third", "middle third", "largest third"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!thirds[i].empty()) groups.push_back(fabric_of(file, names[i], thirds[i]));
  }
}

/// The classes of blocks and of their nearest neighbours; none where one class occurs.
std::optional<NeighbourTest> neighbours_of(const Comparison& comparison, std::uint32_t file,
                                           const std::string& scheme, const FabricBlocks& blocks) {
  PairedClasses pairs;
  std::map<std::string, std::uint32_t> numbers;
  for (const auto& [realisation, of_realisation] : by_realisation(blocks)) {
    if (of_realisation.size() < 2) continue;
    std::vector<Vec3> places;
    const std::size_t first = pairs.classes.size();
    for (const LyingBlock* block : of_realisation) {
      const RunRow& row = comparison.rows[block->row];
      const std::string& key = scheme == "garcia" ? row.block->garcia : row.block->sneed_folk;
      const auto next = static_cast<std::uint32_t>(numbers.size());
      pairs.classes.push_back(numbers.emplace(key, next).first->second);
      pairs.strata.push_back(realisation);
      places.push_back(row.record->result.final_state.position);
    }
    for (const std::size_t other : nearest_others(places)) pairs.partners.push_back(first + other);
  }
  if (numbers.size() < 2) return std::nullopt;
  NeighbourTest test = same_class_test(pairs, kFabricSeed);
  test.file = file;
  test.scheme = scheme;
  if (test.realisations < 2) test.p_value.reset();
  return test;
}

struct FabricProperty {
  const char* name;
  double (*value)(const BlockSummary&);
};
const FabricProperty kProperties[] = {
    {"volume", [](const BlockSummary& block) { return block.volume; }},
    {"I/L", [](const BlockSummary& block) { return block.axes.I / block.axes.L; }},
    {"S/L", [](const BlockSummary& block) { return block.axes.S / block.axes.L; }}};

struct FabricPlace {
  const char* name;
  double (*value)(const LyingBlock&, const RunRow&);
};
const FabricPlace kFabricPlaces[] = {
    {"runout", [](const LyingBlock&, const RunRow& row) { return row.runout; }},
    {"ahead", [](const LyingBlock& block, const RunRow&) { return block.ahead; }},
    {"aside", [](const LyingBlock& block, const RunRow&) { return std::abs(block.aside); }},
    {"relative height",
     [](const LyingBlock& block, const RunRow&) { return block.relative_height; }}};

/// The rank correlation in each realisation that has one.
std::vector<double> correlations_of(const Comparison& comparison, const FabricProperty& property,
                                    const FabricPlace& place, const FabricBlocks& blocks) {
  std::vector<double> found;
  for (const auto& [realisation, of_realisation] : by_realisation(blocks)) {
    std::vector<double> properties, places;
    for (const LyingBlock* block : of_realisation) {
      const RunRow& row = comparison.rows[block->row];
      const double value = place.value(*block, row);
      if (!std::isfinite(value)) continue;
      properties.push_back(property.value(*row.block));
      places.push_back(value);
    }
    const std::optional<TestResult> ranks = spearman(properties, places);
    if (ranks) found.push_back(ranks->statistic);
  }
  return found;
}

void append_sorting(const Comparison& comparison, std::uint32_t file, const FabricBlocks& blocks,
                    std::vector<SortingTrend>& sorting) {
  for (const FabricProperty& property : kProperties) {
    for (const FabricPlace& place : kFabricPlaces) {
      const std::vector<double> found = correlations_of(comparison, property, place, blocks);
      if (found.empty()) continue;
      SortingTrend trend{file, property.name, place.name, fabric_mean(found, {-1.0, 1.0}),
                         std::nullopt};
      const Summary& summary = trend.rank_correlation.summary;
      if (trend.rank_correlation.interval) {
        const auto n = static_cast<double>(summary.count);
        trend.p_value = student_beyond(summary.mean / (summary.std / std::sqrt(n)), n - 1.0);
      }
      sorting.push_back(std::move(trend));
    }
  }
}

}  // namespace

NeighbourTest same_class_test(const PairedClasses& pairs, std::uint64_t seed) {
  NeighbourTest test;
  test.blocks = pairs.classes.size();
  std::map<std::uint32_t, std::vector<std::size_t>> strata;
  for (std::size_t i = 0; i < pairs.strata.size(); ++i) strata[pairs.strata[i]].push_back(i);
  test.realisations = strata.size();
  if (pairs.classes.empty()) return test;
  const auto same = [&](const std::vector<std::uint32_t>& classes) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      count += classes[i] == classes[pairs.partners[i]];
    }
    return static_cast<double>(count);
  };
  // Of n places n_c get class c: another place has the same with (n_c - 1)/(n - 1).
  double expected = 0.0;
  for (const auto& [stratum, members] : strata) {
    std::map<std::uint32_t, double> counts;
    for (const std::size_t i : members) ++counts[pairs.classes[i]];
    for (const auto& [of_class, count] : counts) {
      expected += count * (count - 1.0) / (static_cast<double>(members.size()) - 1.0);
    }
  }
  const auto blocks = static_cast<double>(test.blocks);
  const double observed = same(pairs.classes);
  test.share = observed / blocks;
  test.expected = expected / blocks;
  // Expected counts are no whole numbers: as far from them is so up to rounding.
  const double limit = std::abs(observed - expected) - 1e-9;
  const std::size_t draws = draws_of(test.blocks);
  Random random(seed);
  std::vector<std::uint32_t> dealt = pairs.classes;
  std::size_t as_far = 0;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    for (const auto& [stratum, members] : strata) {
      for (std::size_t i = members.size(); i > 1; --i) {
        std::swap(dealt[members[i - 1]], dealt[members[random.below(i)]]);
      }
    }
    as_far += std::abs(same(dealt) - expected) >= limit;
  }
  test.p_value = static_cast<double>(1 + as_far) / static_cast<double>(1 + draws);
  return test;
}

DepositFabric deposit_fabric(const Comparison& comparison) {
  DepositFabric fabric;
  const std::vector<LyingBlock> all = lying_blocks(comparison);
  std::map<std::uint32_t, FabricBlocks> files;
  for (const LyingBlock& block : all) files[block.file].push_back(&block);
  for (const auto& [file, blocks] : files) {
    append_fabric_groups(comparison, file, blocks, fabric.groups);
    for (const char* scheme : {"garcia", "sneed-folk"}) {
      if (std::optional<NeighbourTest> test = neighbours_of(comparison, file, scheme, blocks)) {
        fabric.neighbours.push_back(std::move(*test));
      }
    }
    append_sorting(comparison, file, blocks, fabric.sorting);
  }
  return fabric;
}

}  // namespace clast
