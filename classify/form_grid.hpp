#pragma once
/// Regular grids of shapes in the classification diagrams.
#include <vector>

#include "classify/form.hpp"

namespace clast {

/// Returns a triangular grid of (steps + 1)(steps + 2)/2 shapes in the Sneed-Folk triangle, with L
/// = 1. In its rows, S/L decreases from 1 to `min_ratio`. The first row has one point, and each
/// further row has one more. Along a row, (L - I)/(L - S) increases from 0 (platy) to 1
/// (elongated).
/// @param min_ratio  smallest S/L, in (0, 1)
/// @throws InputError  if `steps` is not in 1 to 100 or `min_ratio` is out of range
/// @cite sneed1958
std::vector<Axes> sneed_folk_grid(int steps, double min_ratio = 0.2);

/// Returns a grid of (steps + 1)^2 shapes in the Zingg diagram, with L = 1. I/L and S/I each have
/// equal steps from `min_ratio` to 1; S/I varies fastest.
/// @throws InputError  if `steps` is not in 1 to 100 or `min_ratio` is out of range
/// @cite zingg1935
std::vector<Axes> zingg_grid(int steps, double min_ratio = 0.3);

}  // namespace clast
