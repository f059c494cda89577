#pragma once
/// Scans of real stones and made bodies, turned over in between: joined right, bracketed or
/// refused.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace clast {

/// A kind of cases.
struct JoinKind {
  std::string name;
  std::size_t seed = 0;         ///< offset of the seeds
  std::size_t quick_cases = 0;  ///< number of cases if none is given
};

/// Kinds of cases:
/// - same, little: two scans of one stone with an overlap of 30 to 60 and of 10 to 20 %
/// - other, mirrored, scaled: two scans that do not fit
/// - three, four, five, eight: as many scans of one stone, each of which overlaps the one before by
///   30 to 60 %
/// - sources, strips: one scan of two to four passes that are displaced by 0.5 to 3 % of the
///   largest extent, with and without the pass of each point
/// - scale: two scans of which the second has an unknown scale; overlaps as in same and little
/// - symmetric: two scans of parts of balls, boxes, prisms and other bodies with symmetries
const std::vector<JoinKind>& join_kinds();

/// Result of a case.
struct JoinRow {
  /// - right: the volume and L, I, S are within 1 %, and the class is that of the body unless this
  ///   is within 1 % of a limit
  /// - bracketed: otherwise, but the bounds hold the volume
  /// - near: otherwise, but the volume is within 1 %
  /// - refused
  /// - wrong: none of these, or scans that do not fit were joined
  ///
  /// For an unknown scale: error of at most 0.5 % and 95 % interval instead of volume and bounds.
  std::string outcome;
  std::string text;  ///< kind, number, overlap, outcome, errors, bounds or reason
};

/// Makes, joins and judges one case.
/// @param base  seed of the study
JoinRow run_join_case(const JoinKind& kind, std::size_t number, std::uint64_t base);

}  // namespace clast
