#pragma once
/// What pieces of a body count more than once, by integrating along vertical columns.
#include <cstddef>

#include "massprops/line_pieces.hpp"
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

/// Columns in square grids over a body.
///
/// Along each column core and pieces are intervals, so what they count more than once (sum of the
/// intervals less their union, less the known overlaps of the skin) is integrated exactly; only
/// across the columns is there a quadrature, by the midpoint rule. Where pieces do not overlap,
/// whole columns add nothing and there is no error.
class Columns {
 public:
  /// @param core  as `make_skin` took it; origin near the centre, for the scatter of M
  Columns(const TriangleMesh& core, const Skin& skin);

  /// What a grid of `per_side` columns along the longer horizontal side finds.
  ///
  /// The scatter comes from the twist of each block of two by two columns (the sum along one
  /// diagonal less that along the other), which has the variance of the block's sum when the
  /// errors of columns are independent, and to which a linear course, free of error, adds nothing.
  /// Regions so small that no column need meet them show no scatter: when fewer than ten columns
  /// meet anything, `unseen` is three columns of the height of the radius. Regions that random
  /// columns meet three times on average stay unmet once in twenty.
  Excess excess(std::size_t per_side) const;

 private:
  Bounds box_;
  double radius_;
  LineTriangles triangles_;
  LinePieces pieces_, overlaps_;
};

}  // namespace clast
