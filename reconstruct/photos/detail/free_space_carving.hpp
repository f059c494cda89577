#pragma once
/// Free space between cameras and the observed surface.
#include <vector>

#include "reconstruct/photos/detail/pair_view.hpp"
#include "reconstruct/underside/free_space_grid.hpp"

namespace clast::photos_detail {

/// Marks the cubes of the region that are free space. A cube is free if all depths of a pair along
/// lines of sight through it are behind the cube by more than the depth error. Most of these depths
/// must agree with other pairs.
/// @param agreed  one image per view, CV_8U: 1 if other pairs agree with the depth
/// @param tolerance  disparity error that defines the depth error, px
FreeSpaceGrid carve_free_space(const std::vector<PairProjection>& views,
                               const std::vector<cv::Mat>& agreed, const PhotoRegion& region,
                               double tolerance, unsigned threads);

}  // namespace clast::photos_detail
