#pragma once
/// Where runs pass, cell by cell of a map.
#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast {

/// Reach probability, passages, energy (mean, p95, max), passing height (p95) and velocity (max).
/// Each run counts once in every cell that the path of its centre crosses, with its largest value
/// there, read from its stored trajectory; without trajectories there are no cells. A cell is about
/// a four-hundredth of the longer side, a round number of metres, and at least 0.5 m.
MapRasterSet compute_path_rasters(const Comparison& comparison);

}  // namespace clast
