#pragma once
/// Search for poses of a surface with unknown scale.
#include <vector>

#include "reconstruct/registration/detail/pose_search.hpp"

namespace clast::reconstruct_detail {

/// Searches poses (`search_poses`) at scales from 0.7 to 1.4, in steps of 9 %, and estimates the
/// scale from the best poses at each.
/// @param threads  number of threads; does not affect the result
/// @return  the highest score first
std::vector<PoseCandidate> search_similarities(const SampledSurface& fixed,
                                               const SampledSurface& moving, unsigned threads);

}  // namespace clast::reconstruct_detail
