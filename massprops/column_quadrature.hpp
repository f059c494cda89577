#pragma once
/// Overlap of the convex pieces of a body, integrated along vertical columns.
#include <cstddef>

#include "massprops/line_pieces.hpp"
#include "massprops/offset_layer.hpp"

namespace clast::massprops_detail {

struct OverlapIntegral {
  Moments moments;            ///< of the multiply counted volume
  double volume_error = 0.0;  ///< bound on the volume error, m^3
  double second_moment_error =
      0.0;  ///< of tr(M) I - M, M its second moment, in the Frobenius norm, m^5
};

/// Quadrature over square grids of vertical columns.
///
/// Along each column the core and the pieces are intervals, so that their overlap (sum of the
/// intervals minus their union minus known overlaps) is integrated exactly; across the columns the
/// midpoint rule is used. Columns without overlap contribute no error.
class ColumnQuadrature {
 public:
  /// @param core  as `decompose_offset_layer` took it; origin near its centre, about which M is
  /// taken
  ColumnQuadrature(const TriangleMesh& core, const OffsetLayer& skin);

  /// Integrates over a grid with `columns_per_side` columns along the longer horizontal side.
  ///
  /// The error is the largest of two estimates, plus an allowance (docs/theory.md):
  /// - Three standard errors, from the twist of each block of two by two columns (the sum along one
  /// diagonal minus the sum along the other). If the errors of the columns are independent, the
  /// twist has the variance of the block's sum; linear variation, which the midpoint rule
  /// integrates exactly, cancels.
  /// - The largest deviation of the four grids of half the density from their mean. It shows errors
  /// common to neighbouring columns, such as along an edge in the direction of the grid.
  /// - Small regions that no column meets appear in neither estimate. If fewer than ten columns
  /// meet an overlap, three columns of the height of the radius are added: a region that random
  /// columns meet three times on average is missed once in twenty.
  OverlapIntegral integrate_overlap(std::size_t columns_per_side) const;

 private:
  Bounds box_;
  double radius_;
  VerticalLineTriangles triangles_;
  VerticalLinePieces pieces_, overlaps_;
};

}  // namespace clast::massprops_detail
