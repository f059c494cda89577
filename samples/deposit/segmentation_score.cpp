#include "samples/deposit/segmentation_score.hpp"

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "samples/deposit/point_grid.hpp"

namespace clast {
namespace {

double ratio_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// Points that true and proposed blocks share.
struct PointCounts {
  std::map<std::uint32_t, std::size_t> of_truth, of_proposal;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;  ///< truth, proposal
};

PointCounts count_points(std::span<const std::uint32_t> truth,
                         std::span<const std::uint32_t> proposed) {
  PointCounts counts;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ++counts.of_truth[truth[i]];
    ++counts.of_proposal[proposed[i]];
    ++counts.shared[{truth[i], proposed[i]}];
  }
  return counts;
}

}  // namespace

double SegmentationScore::precision() const { return ratio_of(matched, matched + false_proposals); }
double SegmentationScore::recall() const { return ratio_of(matched, eligible); }
double SegmentationScore::close_fraction() const { return ratio_of(close, matched); }

std::vector<std::uint32_t> align_labels(const LabelledCloud& truth, const LabelledCloud& labelled,
                                        double tolerance) {
  const auto differs = [&](std::size_t i) {
    return (truth.points[i] - labelled.points[i]).norm() > tolerance;
  };
  bool in_order = truth.points.size() == labelled.points.size();
  for (std::size_t i = 0; in_order && i < truth.points.size(); ++i) in_order = !differs(i);
  if (in_order) return labelled.blocks;

  PointGrid grid(std::max(10.0 * tolerance, 1e-6));
  for (const Vec3& point : truth.points) grid.add(point);
  std::vector<std::uint32_t> blocks(truth.points.size(), 0);
  std::vector<char> is_labelled(truth.points.size(), 0);
  for (std::size_t i = 0; i < labelled.points.size(); ++i) {
    const Vec3& point = labelled.points[i];
    std::uint32_t nearest = kNoIndex;
    double least = std::numeric_limits<double>::infinity();
    grid.any_within(point, tolerance, [&](std::uint32_t candidate) {
      const double distance = (truth.points[candidate] - point).squaredNorm();
      if (distance < least) {
        least = distance;
        nearest = candidate;
      }
      return false;
    });
    if (nearest == kNoIndex) {
      throw InputError("labelled point " + std::to_string(i + 1) + " at " + format_point(point) +
                       " is no point of the scan; write the points of scan.ply with all digits "
                       "and without an offset");
    }
    if (is_labelled[nearest]) {
      throw InputError("labelled point " + std::to_string(i + 1) + " at " + format_point(point) +
                       " repeats an earlier one; write every point once");
    }
    is_labelled[nearest] = 1;
    blocks[nearest] = labelled.blocks[i];
  }
  return blocks;
}

SegmentationScore score_segmentation(std::span<const std::uint32_t> true_blocks,
                                     std::span<const std::uint32_t> proposed_blocks,
                                     std::span<const TrueBlock> blocks) {
  if (true_blocks.size() != proposed_blocks.size()) {
    throw InputError("there are " + std::to_string(proposed_blocks.size()) + " labels for " +
                     std::to_string(true_blocks.size()) + " points");
  }
  const PointCounts counts = count_points(true_blocks, proposed_blocks);
  SegmentationScore score;
  std::map<std::uint32_t, std::size_t> rows;
  for (const TrueBlock& block : blocks) {
    rows[static_cast<std::uint32_t>(block.block)] = score.blocks.size();
    score.blocks.push_back({.block = static_cast<std::uint32_t>(block.block),
                            .eligible = block.is_eligible(),
                            .visible_fraction = block.visible_fraction});
  }
  const auto is_eligible = [&](std::uint32_t truth) {
    const auto row = rows.find(truth);
    return row != rows.end() && score.blocks[row->second].eligible;
  };

  std::map<std::uint32_t, double> matched;            // largest IoU with an eligible block
  std::map<std::uint32_t, std::size_t> not_eligible;  // points on blocks that are not eligible
  std::map<std::uint32_t, std::size_t> swallowed;     // eligible blocks mostly inside
  for (const auto& [pair, shared] : counts.shared) {
    const auto& [truth, proposal] = pair;
    if (truth == 0 || proposal == 0) continue;
    const std::size_t points = counts.of_truth.at(truth);
    const std::size_t proposed = counts.of_proposal.at(proposal);
    if (!is_eligible(truth)) not_eligible[proposal] += shared;
    const auto row = rows.find(truth);
    if (row == rows.end()) continue;
    BlockScore& block = score.blocks[row->second];
    const double iou = ratio_of(shared, points + proposed - shared);
    if (iou > block.iou) {
      block.iou = iou;
      block.proposal = proposal;
    }
    if (2 * shared > proposed && ratio_of(shared, points) > kPartFraction) ++block.parts;
    if (!block.eligible) continue;
    double& largest = matched[proposal];
    largest = std::max(largest, iou);
    if (2 * shared > points) ++swallowed[proposal];
  }
  for (const auto& [proposal, points] : counts.of_proposal) {
    if (proposal == 0) continue;
    ++score.proposals;
    if (swallowed[proposal] > 1) ++score.under_segmented;
    if (matched[proposal] > kMatchingIou) continue;
    if (2 * not_eligible[proposal] > points) {
      ++score.ignored_proposals;
      continue;
    }
    ++score.false_proposals;
    const auto ground = counts.shared.find({0, proposal});
    if (ground != counts.shared.end() && 2 * ground->second > points) ++score.on_ground;
  }
  for (const BlockScore& block : score.blocks) {
    if (!block.eligible) continue;
    ++score.eligible;
    if (block.is_matched()) ++score.matched;
    if (block.iou > kCloseIou) ++score.close;
    if (block.parts > 1) ++score.over_segmented;
  }
  return score;
}

}  // namespace clast
