#pragma once
/// Corrections of a segmented deposit by its user.
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/types.hpp"

namespace clast {

enum class DepositEditKind {
  kAccept,  ///< confirms a block
  kDrop,    ///< makes a block part of the ground
  kMerge,   ///< makes one block of two or more
  kCut,     ///< divides a block along a line
};

/// Returns "accept", "drop", "merge" or "cut".
std::string name_of(DepositEditKind kind);

/// Correction of a segmentation. Blocks are named by points on them, so that a correction remains
/// valid if the segmentation changes a little. Coordinates are in m, in the frame of the scan with
/// z up.
struct DepositEdit {
  DepositEditKind kind = DepositEditKind::kAccept;
  /// A point on each block, near a point of the scan: two or more for a merge, otherwise one.
  std::vector<Vec3> points;
  /// Line of a cut, two or more points; its first and last segments extend without limit.
  std::vector<Vec3> line = {};
  /// Direction in which the line was drawn. The cut contains the lines of sight through the line.
  Vec3 view = -Vec3::UnitZ();

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const DepositEdit& edit, Visit&& visit) {
  const auto& [kind, points, line, view] = edit;
  visit("kind", name_of(kind));
  visit("points", points);
  visit("line", line);
  visit("view", view);
}

/// Reasons why edits do not fit a cloud, by the numbers of the edits, from 1.
using EditMisfits = std::map<std::size_t, std::string>;

/// Segmentation after corrections. Labels are 0 for ground and 1, 2, ... without gaps for blocks.
struct EditedLabels {
  std::vector<std::uint32_t> labels;  ///< one per point
  /// Label before the edits of the block, or of the block that it was cut from; one per label.
  std::vector<std::uint32_t> sources;
  /// Number of the edit that accepts a block, from 1; 0: none. One per label.
  std::vector<std::size_t> accepted_by;
  EditMisfits misfits;  ///< edits that were not applied
};

/// Applies edits in their order, each to the result of those before it. Edits of different blocks
/// may be interchanged without effect on the result. An accepted block that is then merged or cut
/// is no longer accepted. A merged block has the lowest of the labels, and a cut block keeps its
/// label on the side of its first point. The other side gets a new label. Edits that fit no block
/// are not applied.
/// @param labels  label of each point; 0: ground
/// @param points  points of the scan, or of a part of it, m
/// @param spacing  median point spacing, m
/// @throws InputError  if an edit is invalid; names its number, kind and place
EditedLabels apply_deposit_edits(std::vector<std::uint32_t> labels, std::span<const Vec3> points,
                                 double spacing, std::span<const DepositEdit> edits);

/// Refuses edits that were not applied.
/// @throws InputError  if there are any; names number, kind and place of the first, and the reason
void check_edits_fit(std::span<const DepositEdit> edits, const EditMisfits& misfits);

}  // namespace clast
