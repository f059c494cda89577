#pragma once
/// Surface of a body for distances and samples.
#include <cstddef>
#include <vector>

#include "mesh/triangle_tree.hpp"

namespace clast::particles_detail {

/// Surface at a distance `radius` outside a solid, which may be 0. The solid has far fewer
/// triangles than a mesh of that surface, and distances from it are exact.
class BodySurface {
 public:
  /// @param solid  closed, outward
  BodySurface(TriangleMesh solid, double radius);
  BodySurface(const BodySurface&) = delete;
  BodySurface& operator=(const BodySurface&) = delete;

  /// Bounding box of the surface.
  const Bounds& box() const { return box_; }

  struct Closest {
    double distance = 0.0;         ///< signed, negative inside
    Vec3 outward = Vec3::UnitX();  ///< unit gradient of the distance
    std::uint32_t triangle = 0;    ///< of the solid

    Vec3 foot(const Vec3& from) const { return from - distance * outward; }
  };
  /// Returns signed distance and direction of the surface. Inside the body, near reflex edges of
  /// the solid, the surface is farther by up to 1 / cos(b / 2) - 1 of the radius, b being the angle
  /// between the two faces' normals.
  /// @param hint  index of a triangle that is probably near; affects only the speed
  Closest closest(const Vec3& point, std::uint32_t hint = 0) const;

  /// Samples about `count` points uniformly over the area. The seed is fixed.
  std::vector<Vec3> sample(std::size_t count) const;
  /// Returns about `most` of the points outside the vertices of the solid, or all if there are
  /// fewer. The sharpest corners are among them.
  std::vector<Vec3> corners(std::size_t most) const;
  double area() const;  ///< within about 1 %

 private:
  std::vector<Vec3> exposed(const std::vector<Vec3>& points) const;

  TriangleMesh solid_;
  double radius_;
  TriangleMesh rounded_;  ///< of the surface; parts that meet at reflex edges intersect inside
  TriangleTree tree_;
  Bounds box_;
  double exposed_part_ = 1.0;  ///< of the area of `rounded_`
};

}  // namespace clast::particles_detail
