#pragma once
/// Overlap of the convex pieces of a body, integrated along vertical columns.
#include <cstddef>

#include "massprops/line_pieces.hpp"
#include "massprops/offset_layer.hpp"

namespace clast::massprops_detail {

struct OverlapIntegral {
  SolidMoments moments;       ///< moments of the volume that is counted more than once
  double volume_error = 0.0;  ///< bound on the volume error, m^3
  double second_moment_error =
      0.0;  ///< bound on the error of tr(M) I - M with second moment M, Frobenius norm, m^5
};

/// Quadrature over square grids of vertical columns.
///
/// Along a column, the core and the pieces are intervals. Their overlap is the sum of the intervals
/// minus their union minus the known overlaps, and is integrated exactly. Across the columns, the
/// midpoint rule is used. Columns without overlap contribute no error.
class ColumnQuadrature {
 public:
  /// Prepares the quadrature of a core and its offset layer.
  /// @param core  core of `decompose_offset_layer`; moments are about the origin, near its centre
  ColumnQuadrature(const TriangleMesh& core, const OffsetLayer& skin);

  /// Integrates over a grid with `columns_per_side` columns along the longer horizontal side. The
  /// stated error is the larger of the first two values below plus the third (docs/theory.md):
  ///
  /// - Three standard errors. They follow from the difference of the two diagonal sums in each
  ///   block of two by two columns.
  /// - The largest deviation of the four grids of half the density from their mean. It shows errors
  ///   common to neighbouring columns.
  /// - If fewer than ten columns meet an overlap: the volume of three columns with the height of
  ///   the radius, for small regions that no column meets.
  OverlapIntegral integrate_overlap(std::size_t columns_per_side) const;

 private:
  Bounds box_;
  double radius_;
  TriangleLineCrossings triangles_;
  PieceLineClipper pieces_, overlaps_;
};

}  // namespace clast::massprops_detail
