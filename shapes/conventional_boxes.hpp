#pragma once
/// Boxes by conventions other than smallest volume, for comparison with measured axes.
#include <span>

#include "shapes/oriented_box.hpp"

namespace clast {

/// Calliper (Feret) box of the rounded body: L is its largest diameter, I the largest width
/// perpendicular to L, S the width perpendicular to both, as in Krumbein's definition; ties go to
/// the smaller box. Callipers used without right angles can give a larger S.
/// @throws GeometryError  if there are no points
/// @cite krumbein1941
OrientedBox feret_box(std::span<const Vec3> points, double radius = 0.0);

/// Box along the principal axes. If moments agree to 1e-6 of the largest, the axes are not unique,
/// and the smallest box over the free axes is taken.
/// @param axes  columns, orthonormal
/// @param moments  of the same axes, in any unit, ascending or descending
OrientedBox principal_box(std::span<const Vec3> points, const Mat3& axes, const Vec3& moments,
                          double radius = 0.0);

/// Box along the eigenvectors of the covariance of the hull vertices, equally weighted. Dense
/// vertices of a scan bias the axes; points on a flat face are vertices or not by rounding.
/// @throws GeometryError  if there are no points
OrientedBox pca_box(std::span<const Vec3> points, double radius = 0.0);

}  // namespace clast
