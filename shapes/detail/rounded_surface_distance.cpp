#include "shapes/detail/rounded_surface_distance.hpp"

#include <algorithm>

namespace clast::shapes_detail {

namespace {

/// Shares of the radius by which a point may lie inside the body and still count as on its skin: as
/// computed in one step, and as the end of many.
constexpr double kOnSkin = 1e-9, kNearSkin = 1e-6;
constexpr int kProjections = 30;   ///< towards a crease of the skin
constexpr double kMinStep = 0.01;  ///< along a ray out of the body, in radii

}  // namespace

SurfaceDistance RoundedSurfaceDistance::operator()(const Vec3& point, std::uint32_t& hint) const {
  const TriangleTree::SignedClosest near = core_.signed_closest_point(point, hint);
  hint = near.triangle;
  if (near.distance >= radius_) return {near.distance - radius_};
  if (radius_ == 0.0) return {near.distance};
  TriangleTree::SignedClosest at = near;
  for (int i = 0; i < kProjections; ++i) {
    const Vec3 skin = at.foot + radius_ * at.outward;
    at = core_.signed_closest_point(skin, at.triangle);
    if (at.distance >= (1.0 - (i == 0 ? kOnSkin : kNearSkin)) * radius_) {
      if (i == 0) return {near.distance - radius_};
      return {-((skin - point).norm() + kNearSkin * radius_), false};
    }
  }
  double shortest = exit_distance(point, near.outward, farthest_, hint);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        shortest = exit_distance(point, Vec3(x, y, z).normalized(), shortest, hint);
      }
    }
  }
  return {-shortest, false};
}

/// Length of a ray that ends outside the body, at most `longest`. A ball about a point at distance
/// s from the core reaches no skin within r - s, so steps of that length miss none.
double RoundedSurfaceDistance::exit_distance(const Vec3& point, const Vec3& direction,
                                             double longest, std::uint32_t& hint) const {
  for (double length = 0.0; length < longest;) {
    const TriangleTree::SignedClosest at =
        core_.signed_closest_point(point + length * direction, hint);
    const double left = radius_ - at.distance;
    if (left <= 0.0) return length;
    length += std::max(left, kMinStep * radius_);
  }
  return longest;
}

}  // namespace clast::shapes_detail
