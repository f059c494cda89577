#pragma once
/// Boxes by other conventions than smallest volume, for comparison with axes that were measured so.
#include <span>

#include "shapes/oriented_box.hpp"

namespace clast {

/// What callipers give in the field, on the rounded body: L is the longest distance between two of
/// its points, I its longest width across L, S its width across both. Among equally long L and I
/// the smallest box is taken. The three are at right angles, as in Krumbein's definition; callipers
/// used freely can give a larger S.
/// @throws GeometryError  no points
/// @cite krumbein1941
OrientedBox feret_box(std::span<const Vec3> points, double radius = 0.0);

/// The box along principal axes. Where moments agree to 1e-6 of the largest, the axes between them
/// are a convention and not the body's: there the smallest box is taken of all that the free axes
/// allow.
/// @param axes     columns, orthonormal
/// @param moments  of the same axes, in any unit, ascending or descending
OrientedBox principal_box(std::span<const Vec3> points, const Mat3& axes, const Vec3& moments,
                          double radius = 0.0);

/// Along the eigenvectors of the covariance of the hull's corners, each counted once. Interior
/// points do not matter, but where a scan has many corners they draw the axes; points that lie on a
/// flat face are corners or not by rounding.
/// @throws GeometryError  no points
OrientedBox pca_box(std::span<const Vec3> points, double radius = 0.0);

}  // namespace clast
