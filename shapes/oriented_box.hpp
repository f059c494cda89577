#pragma once
/// Bounding boxes of a body, with the axes L >= I >= S by which shape classes are defined.
#include <span>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Box with sides L >= I >= S along the columns of `axes`.
struct OrientedBox {
  Vec3 centre = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  ///< columns: unit directions of L, I, S; right-handed
  Vec3 lengths = Vec3::Zero();   ///< L, I, S, m

  double volume() const { return lengths.prod(); }
};

/// True if the volume of `a` is smaller. If volumes agree to 1e-11, areas are compared, then L.
bool is_smaller(const OrientedBox& a, const OrientedBox& b);

/// Computes the box of smallest volume around balls of `radius` at the points. It is the smallest
/// box of the rounded body with these core vertices. The result is bit-identical for any order of
/// the points. Ties are broken as in `is_smaller`. Coplanar points have a flat box.
/// @throws GeometryError  if there are no points
/// @cite orourke1985
OrientedBox smallest_box(std::span<const Vec3> points, double radius = 0.0);

OrientedBox smallest_box(const SpheroPolyhedron& body);

/// Returns the box along given axes, with sides sorted L >= I >= S. Sides below 1e-12 L are zero.
/// @param axes  columns, orthonormal
OrientedBox box_with_axes(std::span<const Vec3> points, const Mat3& axes, double radius = 0.0);

}  // namespace clast
