#pragma once
/// Decision whether the best pose of a scan is that of the block.
#include <string>
#include <vector>

#include "reconstruct/registration/detail/disagreement.hpp"

namespace clast::reconstruct_detail {

/// A scan that is to be added to a group.
struct ScanToAdd {
  const SampledSurface* surface = nullptr;
  std::string name;         ///< for messages
  ScanGroup group;          ///< scans with known poses
  std::string group_names;  ///< for messages
  Quat first_from_group;    ///< rotation to the first scan of the input, for messages
  bool is_picked = false;   ///< true if its pose follows from places that were picked
  bool is_near = false;     ///< true if its pose was nearly known
  bool has_free_scale = false;
};

/// Checks that one of the poses found for a scan is that of the block.
/// @param poses  in the frame of the group, the best first
/// @returns number of poses that give the same body as the best, itself included
/// @throws GeometryError  if the best pose has too little overlap, if the scans disagree at it, if
///                        others that are nearly as good give other bodies, or if the surfaces can
///                        slide along each other
std::size_t check_best_pose(const ScanToAdd& scan, const std::vector<PoseCandidate>& poses);

/// True if a scale differs from 1 by more than its error.
bool is_scale_different(const ScaleEstimate& estimate);

/// A fraction in percent with two digits, such as "12 %".
std::string format_percent_of(double fraction);

}  // namespace clast::reconstruct_detail
