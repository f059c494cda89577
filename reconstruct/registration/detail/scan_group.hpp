#pragma once
/// Scans that have a common frame, and the ways in which another scan fits them.
#include <memory>
#include <vector>

#include "reconstruct/registration/detail/pose_search.hpp"

namespace clast::reconstruct_detail {

/// A scan at its pose.
struct PlacedSurface {
  const SampledSurface* sampled = nullptr;
  Similarity first_from;
};

using ScanGroup = std::vector<PlacedSurface>;

/// Compares a surface at a pose with all surfaces of a group. Matched and contradicted fractions
/// are sums over the group.
SurfaceAgreement compare_with_group(const ScanGroup& group, const PlacedSurface& added);

/// Refines the poses of a group and an added surface together, and compares the added surface.
PoseCandidate refine_in_group(const ScanGroup& group, const PlacedSurface& added);

/// True if a group with a surface at either of two poses is the same body: no part of the surface
/// contradicts its copy at the other pose, and hardly any part lies where nothing else is.
bool is_same_body(const ScanGroup& group, const SampledSurface& added, const Similarity& pose,
                  const Similarity& other);

}  // namespace clast::reconstruct_detail
