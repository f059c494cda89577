#pragma once
/// Rasters of passage counts, energy, height and speed along the paths of runs.
#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast {

/// Computes the layers reach probability, passages, energy (mean, p95, max), passing height (p95)
/// and velocity (max). Each run counts once in each cell crossed by its centre, with its largest
/// value there; empty without stored trajectories. The cell size is about 1/400 of the longer side,
/// rounded, and at least 0.5 m.
MapRasterSet compute_path_rasters(const Comparison& comparison);

}  // namespace clast
