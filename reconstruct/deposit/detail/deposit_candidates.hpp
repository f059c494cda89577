#pragma once
/// Regions of a cloud that may be blocks, with their bodies.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/deposit/deposit.hpp"
#include "reconstruct/deposit/detail/plan_tiles.hpp"
#include "reconstruct/deposit/detail/scan_extent.hpp"

namespace clast::reconstruct_detail {

/// A region that may be a block.
struct DepositCandidate {
  DepositBlock block;                     ///< without contacts
  Vec3 centre = Vec3::Zero();             ///< mean of its points, m
  std::optional<LeftOutReason> left_out;  ///< empty for a block
  /// One point of each region that it touches.
  std::vector<std::uint32_t> contact_points;
};

struct DepositCandidates {
  std::vector<DepositCandidate> candidates;  ///< in the order of their first points
  double spacing = 0.0;                      ///< median point spacing, m
  EditMisfits misfits;                       ///< edits that do not fit the points
};

/// Segments a cloud and estimates the bodies of those regions whose centres are in `core`.
/// @param points  at least 100
/// @param scan  extent of the scan of which the points are a part
DepositCandidates find_candidates(std::span<const Vec3> points, const PlanBox& core,
                                  const ScanExtent& scan, const DepositOptions& options);

}  // namespace clast::reconstruct_detail
