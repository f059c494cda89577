#include "study/block_stiffness.hpp"

#include <algorithm>
#include <array>

#include "core/number_text.hpp"
#include "study/detail/results_layout.hpp"

namespace clast {

using namespace study_detail;
namespace {

constexpr std::array<const char*, 6> kHeadings{"k_n, N/m",         "k_t, N/m",
                                               "k_r, N m/rad",     "time step, s",
                                               "settled depth, m", "deepest impact, m"};

BlockStiffness without_runs(const std::string& id) {
  BlockStiffness block{id, 0, {}};
  visit_stiffness([&](const char* name, const auto&...) {
    block.values.push_back({name, kHeadings.at(block.values.size()), {}});
  });
  return block;
}

}  // namespace

void ValueRange::include(double value) {
  // In this order a comparison with what is not a number keeps what there was.
  low = std::min(low, value);
  high = std::max(high, value);
}

std::vector<BlockStiffness> stiffness_by_block(std::span<const BlockSummary> blocks,
                                               std::span<const RunRecord> runs) {
  std::vector<BlockStiffness> list;
  for (const BlockSummary& block : blocks) list.push_back(without_runs(block.id));
  for (const RunRecord& run : runs) {
    BlockStiffness& block = list[run.block];
    ++block.runs;
    auto value = block.values.begin();
    visit_stiffness([&](const auto&, const auto&, const auto&, const auto& field) {
      (value++)->range.include(std::invoke(field, run));
    });
  }
  return list;
}

BlockStiffness over_all(std::span<const BlockStiffness> blocks) {
  BlockStiffness all = without_runs("all " + std::to_string(blocks.size()));
  for (const BlockStiffness& block : blocks) {
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

std::vector<std::string> stiffness_cells(const BlockStiffness& block) {
  std::vector<std::string> cells;
  for (const StiffnessValue& value : block.values) {
    if (value.range.empty()) {
      cells.emplace_back("-");
      continue;
    }
    const std::string low = with_digits(value.range.low, 4);
    const std::string high = with_digits(value.range.high, 4);
    cells.push_back(low == high ? low : low + " to " + high);
  }
  return cells;
}

}  // namespace clast
