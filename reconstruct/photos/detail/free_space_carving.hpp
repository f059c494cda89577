#pragma once
/// Free space between cameras and the observed surface.
#include <vector>

#include "reconstruct/photos/detail/pair_view.hpp"
#include "reconstruct/underside/free_space_grid.hpp"

namespace clast::photos_detail {

/// Marks cubes of the region as free if a pair has only depths behind the cube, beyond the depth
/// error, of which most agree with other pairs.
/// @param agreed  per view, CV_8U: 1 if other pairs agree with the depth
/// @param tolerance  disparity error, px
FreeSpaceGrid carve_free_space(const std::vector<PairProjection>& views,
                               const std::vector<cv::Mat>& agreed, const PhotoRegion& region,
                               double tolerance, unsigned threads);

}  // namespace clast::photos_detail
