#pragma once
/// Blocks of a deposit: a scan of blocks that lie apart, touch, lean on each other or are half
/// buried.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/deposit/deposit_edits.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast {

struct DepositOptions {
  double smallest_axis = 0.0;  ///< least intermediate axis I of a block, m; 0: as far as resolved
  std::vector<DepositEdit> edits = {};  ///< corrections of the segmentation, in their order
  /// Positions of the scanner or the cameras, m. No body reaches into the free space between them
  /// and the points. Empty if they are unknown.
  std::vector<Vec3> stations = {};
  unsigned threads = 1;  ///< number of threads, 0: one per core; does not affect the result
  /// Clouds with more points are segmented in overlapping tiles, which bounds the memory.
  std::size_t tile_points = 4000000;
  ProgressCallback progress = {};  ///< called with the name of each step before it starts

  void check() const;  ///< throws InputError naming the field and its value
};

/// Reason why a part of a deposit is not among its blocks.
enum class LeftOutReason {
  kTooFewPoints,  ///< fewer points than describe a block
  kTooSmall,      ///< smaller than `DepositOptions::smallest_axis`
  kMostlyHidden,  ///< too little of its surface is visible
  kCutByBorder,   ///< a part of it lies outside the scan
  kUncertain,     ///< its outline is probably not that of one block
};

/// Returns a reason in words, such as "cut by the border of the scan".
std::string name_of(LeftOutReason reason);

/// Part of a deposit that may be a block but is not among its blocks.
struct LeftOutPart {
  LeftOutReason reason = LeftOutReason::kTooFewPoints;
  Vec3 centre = Vec3::Zero();  ///< its point that is nearest to the mean of its points, m
  std::size_t points = 0;
};

/// Visible part of a block, and the body that is estimated from it.
struct DepositBlock {
  std::vector<std::uint32_t> points;  ///< ascending indices of its points
  Vec3 centre = Vec3::Zero();         ///< mean of the vertices of the body, m
  TriangleMesh body;                  ///< closed, outward, m
  Vec3 sides = Vec3::Zero();          ///< L, I, S of the smallest box of the body, m
  std::vector<bool> is_observed;      ///< false on the estimated side; one per vertex of `body`
  double spacing = 0.0;               ///< point spacing, m
  double visible_fraction = 0.0;      ///< observed area over the area of the body
  /// Probability that the outline is that of one block: that the intersection over union of its
  /// points and those of a block exceeds 0.5. Calibrated on virtual deposits; 1 if an edit accepts
  /// the block.
  double confidence = 0.0;
  VolumeBracket bounds;                 ///< bounds and 90 % intervals of volume and sides
  std::vector<std::uint32_t> contacts;  ///< ascending indices of the blocks whose points it touches
};

/// Blocks of a deposit, ordered by x, then y of their centres.
struct Deposit {
  std::vector<DepositBlock> blocks;
  std::vector<LeftOutPart> left_out;  ///< ordered by x, then y
  std::vector<std::uint32_t> ground;  ///< ascending indices of the points of ground and fines
  double spacing = 0.0;               ///< median point spacing, m
};

/// Segments a deposit into blocks, ground and fines, and estimates the body of each block.
///
/// Points are grouped into convex patches, and patches into regions whose parts are visible from
/// each other as the parts of one convex body are. All lengths are relative to the point spacing
/// and the size of the regions, none to the extent of the scan.
/// @param points  points without duplicates and outliers, m, z up
/// @throws GeometryError  if there are fewer than 100 points
/// @throws InputError  if an edit fits no block, or accepts a part that is left out
Deposit segment_deposit(std::span<const Vec3> points, const DepositOptions& options = {});

}  // namespace clast
