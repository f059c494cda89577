#pragma once
/// Forms spread evenly over the diagrams that blocks are classified in.
#include <vector>

#include "classify/form.hpp"

namespace clast {

/// Points of the triangle of Sneed & Folk in `steps` steps along each side: of the compact corner
/// one, of each next row one more, (steps + 1)(steps + 2)/2 in all. Rows are S/L from 1 down to
/// `least` in equal steps, points of a row (L - I)/(L - S) from 0 (platy) to 1 (elongated). L = 1.
/// @param least  smallest S/L, in (0, 1)
/// @throws InputError  no step, more than 100, or `least` out of range
/// @cite sneed1958
std::vector<Axes> sneed_folk_grid(int steps, double least = 0.2);

/// Points of Zingg's diagram: I/L and S/I each in `steps` equal steps from `least` to 1,
/// (steps + 1)^2 in all, by I/L and then by S/I. L = 1.
/// @throws InputError  as `sneed_folk_grid`
/// @cite zingg1935
std::vector<Axes> zingg_grid(int steps, double least = 0.3);

}  // namespace clast
