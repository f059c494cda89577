#pragma once
/// Rasters of passage counts, energy, height and speed along the paths of runs.
#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast {

/// Computes raster layers of reach probability, number of passages, energy, passing height and
/// speed along the paths of the runs. A run counts once in each cell that its centre crosses, with
/// its largest value there. Empty if no trajectories are stored.
MapRasterSet compute_path_rasters(const Comparison& comparison);

}  // namespace clast
