#pragma once
/// What pieces of a body count more than once, by integrating along vertical columns.
#include <array>

#include "massprops/skin.hpp"

namespace clast {

/// Columns in a square grid over the body, `per_side` along its longer horizontal side.
///
/// Along each column core and pieces are intervals, so what they count more than once (sum of the
/// intervals less their union, less the known overlaps of the skin) is integrated exactly; only
/// across the columns is there a quadrature, by the midpoint rule. Where pieces do not overlap,
/// whole columns add nothing and there is no error.
///
/// @return the estimates of the four interleaved grids of half the density, by parity of the
///         column's place; their mean is the estimate of the full grid
std::array<Moments, 4> excess_by_columns(const TriangleMesh& core, const Skin& skin,
                                         std::size_t per_side);

}  // namespace clast
