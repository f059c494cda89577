#pragma once
/// Score of a segmentation: points of a cloud by block, against the true blocks.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <vector>

#include "mesh/labelled_cloud.hpp"
#include "samples/deposit/deposit.hpp"

namespace clast {

/// A true block and a proposed block match if the intersection of their points over the union
/// (IoU) exceeds this.
inline constexpr double kMatchingIou = 0.5;
/// IoU of a close match.
inline constexpr double kCloseIou = 0.8;
/// A part of a block: more than this fraction of its points.
inline constexpr double kPartFraction = 0.1;

/// Score of one true block.
struct BlockScore {
  std::uint32_t block = 0;  ///< number of the true block
  bool eligible = false;
  double visible_fraction = 0.0;
  std::uint32_t proposal = 0;  ///< proposed block with the largest IoU; 0 if none shares a point
  double iou = 0.0;            ///< its IoU
  /// Number of proposals of which most points lie on this block, with more than a tenth of its
  /// points each; more than 1: the block is over-segmented.
  std::size_t parts = 0;

  bool is_matched() const { return iou > kMatchingIou; }
};

/// Score of a segmentation.
struct SegmentationScore {
  std::vector<BlockScore> blocks;   ///< all true blocks, in their order
  std::size_t eligible = 0;         ///< number of eligible true blocks
  std::size_t matched = 0;          ///< number of eligible blocks that match a proposal
  std::size_t close = 0;            ///< those with an IoU above `kCloseIou`
  std::size_t proposals = 0;        ///< number of proposed blocks
  std::size_t false_proposals = 0;  ///< those that match no block and are not ignored
  /// Those that match no eligible block, and most of whose points lie on true blocks that are not
  /// eligible.
  std::size_t ignored_proposals = 0;
  std::size_t on_ground = 0;       ///< false ones of which most points lie on the ground
  std::size_t over_segmented = 0;  ///< number of eligible blocks with several parts
  std::size_t under_segmented =
      0;  ///< number of proposals with most points of several eligible blocks

  double precision() const;       ///< matched over matched and false; 0 without proposals
  double recall() const;          ///< matched over eligible
  double close_fraction() const;  ///< close over matched
};

/// Brings labels into the order of the true points.
/// @param truth  true points
/// @param labelled  the same points in any order; some may be missing, and then have the block 0
/// @param tolerance  largest difference of the coordinates of a point, m
/// @throws InputError  if a labelled point is none of the true ones or repeats an earlier one
std::vector<std::uint32_t> align_labels(const LabelledCloud& truth, const LabelledCloud& labelled,
                                        double tolerance);

/// Scores a segmentation. Each IoU is of all points; IoU above 0.5 makes matches unique.
/// @param true_blocks  true block of each point; 0: ground
/// @param proposed_blocks  proposed block of each point; 0: none
/// @param blocks  true blocks; those that no point names count as unseen
SegmentationScore score_segmentation(std::span<const std::uint32_t> true_blocks,
                                     std::span<const std::uint32_t> proposed_blocks,
                                     std::span<const TrueBlock> blocks);

}  // namespace clast
