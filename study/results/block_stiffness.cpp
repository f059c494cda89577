#include "study/results/block_stiffness.hpp"

#include <algorithm>
#include <array>

#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "study/results/detail/results_layout.hpp"

namespace clast {

using namespace study_detail;
namespace {

constexpr std::array<const char*, 7> kHeadings{
    "k_n, N/m",         "k_t, N/m",          "k_r, N m/rad",           "time step, s",
    "settled depth, m", "deepest impact, m", "turn to roll limit, deg"};
constexpr std::size_t kRolling = 2, kRollingLimit = 6;  // indices

BlockStiffnessRanges without_runs(const std::string& id) {
  BlockStiffnessRanges block{id, 0, {}};
  const auto add = [&](const char* name, const auto&...) {
    block.values.push_back({name, kHeadings.at(block.values.size()), {}});
  };
  visit_stiffness(add);
  add("rolling_limit_deg");
  return block;
}

/// The zones that a run meets.
std::span<const GroundParameters> zones_of(const CampaignHeader& header, const RunRecord& run) {
  return run.ground_set < header.ground_sets.size()
             ? std::span(header.ground_sets[run.ground_set].zones)
             : std::span(header.ground);
}

/// Includes k_r and the limit rotation on each zone.
void include_rolling(BlockStiffnessRanges& block, const RunRecord& run, double smallest_side,
                     std::span<const GroundParameters> zones) {
  for (const GroundParameters& zone : zones) {
    const double k_r = zone.rolling_stiffness(run.stiffness.normal, run.stiffness.rolling);
    block.values[kRolling].range.include(k_r);
    const double limit =
        zone.rolling_friction * 0.5 * smallest_side * run.stiffness.normal * run.impact_depth;
    if (limit > 0.0) block.values[kRollingLimit].range.include(kDegreesPerRadian * limit / k_r);
  }
}

}  // namespace

void ValueRange::include(double value) {
  // This order of arguments ignores NaN.
  low = std::min(low, value);
  high = std::max(high, value);
}

std::vector<BlockStiffnessRanges> collect_stiffness_by_block(const CampaignHeader& header,
                                                             std::span<const RunRecord> runs) {
  std::vector<BlockStiffnessRanges> list;
  for (const BlockSummary& block : header.blocks) list.push_back(without_runs(block.id));
  for (const RunRecord& run : runs) {
    BlockStiffnessRanges& block = list[run.block];
    ++block.runs;
    auto value = block.values.begin();
    visit_stiffness([&](const auto&, const auto&, const auto&, const auto& field) {
      const bool by_zone = value - block.values.begin() == kRolling;
      if (!by_zone) value->range.include(std::invoke(field, run));
      ++value;
    });
    include_rolling(block, run, header.blocks[run.block].axes.S, zones_of(header, run));
  }
  return list;
}

BlockStiffnessRanges combine_stiffness(std::span<const BlockStiffnessRanges> blocks) {
  BlockStiffnessRanges all = without_runs("all " + std::to_string(blocks.size()));
  for (const BlockStiffnessRanges& block : blocks) {
    all.runs += block.runs;
    for (std::size_t i = 0; i < all.values.size(); ++i) {
      const ValueRange& range = block.values[i].range;
      if (range.empty()) continue;
      all.values[i].range.include(range.low);
      all.values[i].range.include(range.high);
    }
  }
  return all;
}

std::vector<std::string> format_stiffness_cells(const BlockStiffnessRanges& block) {
  std::vector<std::string> cells;
  for (const StiffnessRange& value : block.values) {
    if (value.range.empty()) {
      cells.emplace_back("-");
      continue;
    }
    const std::string low = format_significant(value.range.low, 4);
    const std::string high = format_significant(value.range.high, 4);
    cells.push_back(low == high ? low : low + " to " + high);
  }
  return cells;
}

}  // namespace clast
