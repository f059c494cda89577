#pragma once
/// Scores of the sizes that a program states for segmented blocks.
#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "samples/deposit/interval_score.hpp"
#include "samples/deposit/segmentation_score.hpp"

namespace clast {

/// Column names of the scored quantities.
inline constexpr std::array<const char*, 4> kBodyQuantities = {"L_m", "I_m", "S_m", "volume_m3"};
/// S and volume are scored for blocks of which more than this fraction was seen.
inline constexpr double kHalfVisible = 0.5;
/// Limits of the groups by visible fraction.
inline constexpr std::array<double, 3> kVisibleLimits = {0.3, 0.5, 0.7};

/// Sizes that a program states for a proposed block.
struct StatedBody {
  std::uint32_t block = 0;            ///< number in the labelled cloud
  std::array<Estimate, 4> estimates;  ///< of `kBodyQuantities`
};

/// Reads stated sizes from a table with the columns `block` and any of `kBodyQuantities`. Optional
/// columns are Q_low, Q_high (hard bounds) and Q_low90, Q_high90 (90 % interval) for a quantity Q,
/// such as `volume_m3_low90`. Empty cells are unknown.
/// @throws InputError  if the table is missing, lacks `block`, names a block twice or has a text in
///                     place of a number
std::vector<StatedBody> read_stated_bodies(const std::filesystem::path& path);

/// Scores of one group of blocks, for each of `kBodyQuantities`.
struct BodyScore {
  double least_visible = 0.0, most_visible = 1.0;  ///< range of the visible fraction of the group
  std::array<EstimateScore, 4> quantities;
};

/// Scores the sizes of the proposals that match eligible true blocks.
/// @return score of all of them, then of each group between `kVisibleLimits`; in the groups, S and
///         volume are scored whatever the visible fraction
std::vector<BodyScore> score_bodies(const SegmentationScore& segmentation,
                                    std::span<const TrueBlock> blocks,
                                    std::span<const StatedBody> stated);

}  // namespace clast
