#pragma once
/// What the convex pieces of a body count more than once, by integrating along vertical columns.
#include <cstddef>

#include "massprops/line_pieces.hpp"
#include "massprops/offset_layer.hpp"

namespace clast::massprops_detail {

/// What columns find, and how well they know it.
struct OverlapIntegral {
  Moments moments;            ///< what is counted more than once
  double volume_error = 0.0;  ///< bound on the error of its volume, m^3
  double second_moment_error =
      0.0;  ///< of tr(M) I - M, M its second moment, in the Frobenius norm, m^5
};

/// Columns in square grids over a body.
///
/// Along each column core and pieces are intervals, so what they count more than once (sum of the
/// intervals less their union, less the known overlaps of the skin) is integrated exactly; only
/// across the columns is there a quadrature, by the midpoint rule. Where pieces do not overlap,
/// whole columns add nothing and there is no error.
class ColumnQuadrature {
 public:
  /// @param core  as `decompose_offset_layer` took it; origin near its centre, about which M is
  /// taken
  ColumnQuadrature(const TriangleMesh& core, const OffsetLayer& skin);

  /// What a grid of `columns_per_side` columns along the longer horizontal side finds.
  ///
  /// Each error is the largest of two estimates, plus an allowance, about which docs/theory.md
  /// says more:
  /// - Three standard errors, from the twist of each block of two by two columns (the sum along one
  ///   diagonal less that along the other). When errors of columns are independent it has the
  ///   variance of the block's sum; a linear course, which costs no error, adds nothing.
  /// - The largest departure from the mean among the four grids of half the density. It shows
  /// errors
  ///   that neighbours have in common, such as along an edge that runs in the direction of the
  ///   grid.
  /// - Regions that no column need meet show in neither. When fewer than ten columns meet anything,
  ///   three columns of the height of the radius are allowed for: what random columns meet three
  ///   times on average they miss once in twenty.
  OverlapIntegral integrate_overlap(std::size_t columns_per_side) const;

 private:
  Bounds box_;
  double radius_;
  VerticalLineTriangles triangles_;
  VerticalLinePieces pieces_, overlaps_;
};

}  // namespace clast::massprops_detail
