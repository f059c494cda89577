#pragma once
/// Regular grids of forms in the classification diagrams.
#include <vector>

#include "classify/form.hpp"

namespace clast {

/// Returns a triangular grid of (steps + 1)(steps + 2)/2 points in the Sneed-Folk triangle: rows by
/// S/L from 1 down to `least`, with one point in the first row and one more in each following row,
/// by (L - I)/(L - S) from 0 (platy) to 1 (elongated). L = 1.
/// @param least  smallest S/L, in (0, 1)
/// @throws InputError  if `steps` is not in 1 to 100 or `least` is out of range
/// @cite sneed1958
std::vector<Axes> sneed_folk_grid(int steps, double least = 0.2);

/// Returns a grid of (steps + 1)^2 points in the Zingg diagram: I/L, then S/I, each in equal steps
/// from `least` to 1. L = 1.
/// @throws InputError  as `sneed_folk_grid`
/// @cite zingg1935
std::vector<Axes> zingg_grid(int steps, double least = 0.3);

}  // namespace clast
