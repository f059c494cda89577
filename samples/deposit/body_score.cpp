#include "samples/deposit/body_score.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "samples/deposit/block_table.hpp"

namespace clast {
namespace {

struct JudgedBody {
  const TrueBlock* truth;
  const StatedBody* stated;
};

BodyScore score_group(std::span<const JudgedBody> bodies, double least, double most,
                      bool is_group) {
  BodyScore score{least, most, {}};
  for (std::size_t q = 0; q < kBodyQuantities.size(); ++q) {
    std::vector<JudgedEstimate> estimates;
    for (const auto& [truth, stated] : bodies) {
      const double visible = truth->visible_fraction;
      const bool is_side_or_volume = q >= 2;
      if (is_group ? visible <= least || visible > most
                   : is_side_or_volume && visible <= kHalfVisible) {
        continue;
      }
      const double value = q < 3 ? truth->axes[static_cast<Eigen::Index>(q)] : truth->volume;
      estimates.push_back({value, stated->estimates[q]});
    }
    score.quantities[q] = score_estimates(estimates);
  }
  return score;
}

}  // namespace

std::vector<StatedBody> read_stated_bodies(const std::filesystem::path& path) {
  const HeadedTable table(path);
  std::vector<StatedBody> bodies;
  std::set<std::uint32_t> known;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    StatedBody body;
    const double number = table.number(row, "block");
    if (!(number >= 1.0 && number <= 1e9)) {
      throw InputError(path.string() + ", row " + std::to_string(row + 1) +
                       ": the block is not a number from 1");
    }
    body.block = static_cast<std::uint32_t>(number);
    if (!known.insert(body.block).second) {
      throw InputError(path.string() + " has block " + std::to_string(body.block) +
                       " twice; leave one row for each block");
    }
    for (std::size_t q = 0; q < kBodyQuantities.size(); ++q) {
      const std::string name = kBodyQuantities[q];
      const auto cell = [&](const std::string& suffix) {
        return table.has(name + suffix) ? table.number(row, name + suffix) : Estimate::kUnknown;
      };
      body.estimates[q] = {cell(""), cell("_low"), cell("_high"), cell("_low90"), cell("_high90")};
    }
    bodies.push_back(body);
  }
  return bodies;
}

std::vector<BodyScore> score_bodies(const SegmentationScore& segmentation,
                                    std::span<const TrueBlock> blocks,
                                    std::span<const StatedBody> stated) {
  std::map<std::uint32_t, const StatedBody*> by_number;
  for (const StatedBody& body : stated) by_number[body.block] = &body;
  std::vector<JudgedBody> judged;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const BlockScore& block = segmentation.blocks[i];
    const auto found = by_number.find(block.proposal);
    if (!block.eligible || !block.is_matched() || found == by_number.end()) continue;
    judged.push_back({&blocks[i], found->second});
  }
  std::vector<BodyScore> scores = {score_group(judged, 0.0, 1.0, false)};
  double least = 0.0;
  for (std::size_t g = 0; g <= kVisibleLimits.size(); ++g) {
    const double most = g < kVisibleLimits.size() ? kVisibleLimits[g] : 1.0;
    scores.push_back(score_group(judged, least, most, true));
    least = most;
  }
  return scores;
}

}  // namespace clast
