#pragma once
/// Rasters of passage counts, energy, height and speed along the paths of runs.
#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast {

/// Computes layers of reach probability, number of passages, energy (mean, 95th percentile,
/// maximum), passing height (95th percentile) and velocity (maximum). A run counts once in each
/// cell that its centre crosses, with its largest value there. Empty if no trajectories are stored.
/// The cell size is about 1/400 of the longer side of the grid and at least 0.5 m.
MapRasterSet compute_path_rasters(const Comparison& comparison);

}  // namespace clast
