#pragma once
/// Bounding boxes of a body, and the axes L >= I >= S on which shape classes are measured.
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

/// True if `a` is smaller: by volume; by area if volumes agree to 1e-11, then by L.
bool is_smaller(const OrientedBox& a, const OrientedBox& b);

/// Computes the box of smallest volume around the points, each swept by a ball of `radius`: the
/// search includes 2 radius in the extents, so the result is the smallest box of the rounded body.
/// The result is bit-identical for any order of the points; ties are broken by area, then by L.
/// Coplanar, collinear or coincident points have a flat box.
/// @throws GeometryError  for no points
/// @cite orourke1985
OrientedBox smallest_box(std::span<const Vec3> points, double radius = 0.0);

OrientedBox smallest_box(const SpheroPolyhedron& body);

/// Returns the box along given axes (columns, orthonormal), with sides sorted L >= I >= S. Extents
/// below 1e-12 of the largest are rounding and count as zero.
OrientedBox box_with_axes(std::span<const Vec3> points, const Mat3& axes, double radius = 0.0);

}  // namespace clast
