#pragma once
/// What pieces of a body count more than once, by integrating along vertical columns.
#include <cstddef>

#include "massprops/skin.hpp"

namespace clast {

/// What columns find, and how well they know it.
struct Excess {
  Moments moments;              ///< what is counted more than once
  double volume_scatter = 0.0;  ///< standard error of its volume, m^3
  double second_scatter = 0.0;  ///< standard error of tr(M) I - M, M its second moment, in the
                                ///< Frobenius norm, m^5
  std::size_t columns = 0;      ///< that meet something counted more than once
  double unseen = 0.0;          ///< volume that may lie between the columns, m^3
};

/// Columns in a square grid over the body, `per_side` along its longer horizontal side.
///
/// Along each column core and pieces are intervals, so what they count more than once (sum of the
/// intervals less their union, less the known overlaps of the skin) is integrated exactly; only
/// across the columns is there a quadrature, by the midpoint rule. Where pieces do not overlap,
/// whole columns add nothing and there is no error.
///
/// The scatter is that of a stratified sample: the variance among the four columns of each two by
/// two block, summed over the blocks. Regions so small that no column need meet them show no
/// scatter; `unseen` allows for them.
Excess excess_by_columns(const TriangleMesh& core, const Skin& skin, std::size_t per_side);

}  // namespace clast
