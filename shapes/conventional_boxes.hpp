#pragma once
/// Boxes by other conventions than smallest volume, for comparison with measured axes.
#include <span>

#include "shapes/oriented_box.hpp"

namespace clast {

/// Returns the calliper (Feret) box of the rounded body, by Krumbein's definition: L is its largest
/// diameter, I the largest width perpendicular to L, and S the width perpendicular to both. If
/// several boxes are possible, the smallest is taken.
/// @throws GeometryError  if there are no points
/// @cite krumbein1941
OrientedBox feret_box(std::span<const Vec3> points, double radius = 0.0);

/// Returns the box along the principal axes of inertia. If moments agree to 1e-6 of the largest,
/// the axes are not unique. The smallest box over all possible axes is then taken.
/// @param axes  principal axes as columns, orthonormal
/// @param moments  moments about these axes, in any unit, ascending or descending
OrientedBox principal_box(std::span<const Vec3> points, const Mat3& axes, const Vec3& moments,
                          double radius = 0.0);

/// Returns the box along the eigenvectors of the covariance of the hull vertices, all with equal
/// weight. The axes are biased if the vertices of a scan are not evenly distributed.
/// @throws GeometryError  if there are no points
OrientedBox pca_box(std::span<const Vec3> points, double radius = 0.0);

}  // namespace clast
