#pragma once
/// Candidate poses of two observed surfaces, by an exhaustive search of rotations.
#include <vector>

#include "reconstruct/registration/detail/sampled_surface.hpp"

namespace clast::reconstruct_detail {

/// Finds poses at which many points of two surfaces with parallel normals coincide. For each
/// rotation of an even grid of all rotations, pairs of points whose normals become parallel vote
/// for the translation between them.
/// @param threads  number of threads; does not affect the result
/// @return the translations with most votes of each rotation, in the order of the rotations
/// @cite alexa2022
std::vector<Pose> search_rotations(const SampledSurface& fixed, const SampledSurface& moving,
                                   unsigned threads);

}  // namespace clast::reconstruct_detail
