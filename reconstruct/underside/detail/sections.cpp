#include "reconstruct/underside/detail/sections.hpp"

#include <algorithm>
#include <array>

namespace clast::reconstruct_detail {

namespace {

/// Intersection of the side from `a` to `b` with the plane z = 0.
Vec2 crossing(const Vec3& a, const Vec3& b) {
  const double fraction = a.z() / (a.z() - b.z());
  return a.head<2>() + fraction * (b.head<2>() - a.head<2>());
}

/// Signed volume of the prism between a triangle and the plane z = 0 below it.
double prism(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec2 u = b.head<2>() - a.head<2>(), v = c.head<2>() - a.head<2>();
  return 0.5 * cross(u, v) * (a.z() + b.z() + c.z()) / 3.0;
}

}  // namespace

HorizontalSections::HorizontalSections(const TriangleMesh& mesh, const Vec3& up) {
  const Bounds box = bounds(mesh);
  origin_ = 0.5 * (box.low + box.high);
  offset_ = origin_.dot(up);
  mesh_ = mesh;
  const Quat rotation = Quat::FromTwoVectors(up, Vec3::UnitZ());
  lowest_ = 1e300, highest_ = -1e300;
  for (Vec3& vertex : mesh_.vertices) {
    vertex = rotation * (vertex - origin_);
    lowest_ = std::min(lowest_, vertex.z() + offset_);
    highest_ = std::max(highest_, vertex.z() + offset_);
  }
}

// The border of the section, run counter-clockwise with the triangles' own turn: half the sum of
// the cross products of its components, by Green's theorem.
double HorizontalSections::area(double height) const {
  const double level = height - offset_;
  double doubled = 0.0;
  for (const TriangleMesh::Triangle& t : mesh_.triangles) {
    std::array<Vec3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = mesh_.vertices[t[k]] - level * Vec3::UnitZ();
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
      const bool alone_above = a.z() > 0.0 && b.z() <= 0.0 && c.z() <= 0.0;
      const bool alone_below = a.z() <= 0.0 && b.z() > 0.0 && c.z() > 0.0;
      if (alone_above) doubled += cross(crossing(a, b), crossing(a, c));
      if (alone_below) doubled += cross(crossing(a, c), crossing(a, b));
    }
  }
  return 0.5 * doubled;
}

double HorizontalSections::volume_above(double height) const {
  const double level = height - offset_;
  double volume = 0.0;
  for (const TriangleMesh::Triangle& t : mesh_.triangles) {
    std::array<Vec3, 3> p;
    int above = 0;
    for (int k = 0; k < 3; ++k) {
      p[k] = mesh_.vertices[t[k]] - level * Vec3::UnitZ();
      above += p[k].z() > 0.0;
    }
    if (above == 3) volume += prism(p[0], p[1], p[2]);
    if (above == 0 || above == 3) continue;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
      const bool alone = (a.z() > 0.0) == (above == 1) && (b.z() > 0.0) != (above == 1) &&
                         (c.z() > 0.0) != (above == 1);
      if (!alone) continue;
      const Vec2 ab = crossing(a, b), ac = crossing(a, c);
      const Vec3 low_ab(ab.x(), ab.y(), 0.0), low_ac(ac.x(), ac.y(), 0.0);
      if (above == 1) {
        volume += prism(a, low_ab, low_ac);
      } else {
        volume += prism(low_ab, b, c) + prism(low_ab, c, low_ac);
      }
    }
  }
  return volume;
}

}  // namespace clast::reconstruct_detail
