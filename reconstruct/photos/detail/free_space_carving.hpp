#pragma once
/// Space between cameras and what they saw.
#include <vector>

#include "reconstruct/photos/detail/pair_view.hpp"
#include "reconstruct/underside/free_space_grid.hpp"

namespace clast::photos_detail {

/// Cubes of the region that pairs looked through: all that such a pair knows about where the cube
/// is in its picture lies behind the cube by more than depths err, and most of it is what other
/// pairs agree with.
/// @param agreed     of each view, CV_8U: 1 where others agree with its depth
/// @param tolerance  px, by which depths differ
FreeSpaceGrid carve_free_space(const std::vector<PairProjection>& views,
                               const std::vector<cv::Mat>& agreed, const PhotoRegion& region,
                               double tolerance, unsigned threads);

}  // namespace clast::photos_detail
