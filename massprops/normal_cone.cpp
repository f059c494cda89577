#include "massprops/normal_cone.hpp"

#include <cmath>
#include <vector>

namespace clast::massprops_detail {
namespace {

using Polygon = std::vector<Vec3>;

/// The part of a spherical polygon on the side u . e <= 0. Its arcs are shorter than half a turn.
Polygon clipped(const Polygon& polygon, const Vec3& e) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& from = polygon[i];
    const Vec3& to = polygon[(i + 1) % polygon.size()];
    const double before = from.dot(e);
    const double after = to.dot(e);
    if (before <= 0.0) result.push_back(from);
    if ((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0)) {
      const Vec3 crossing = std::abs(after) * from + std::abs(before) * to;
      result.push_back(crossing.normalized());
    }
  }
  return result;
}

/// Adds the integrals over a spherical polygon, counter-clockwise from outside. First and second
/// follow from the divergence theorem on the cone over it, so that its arcs suffice.
void add_polygon(const Polygon& polygon, NormalConeIntegrals& sum) {
  double solid_angle = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec3& a = polygon[0];
    const Vec3& b = polygon[i];
    const Vec3& c = polygon[i + 1];
    solid_angle += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  sum.solid_angle += solid_angle;
  sum.second += (solid_angle / 3.0) * Mat3::Identity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    const Vec3 cross = a.cross(b);
    const double sine = cross.norm();
    if (!(sine > 0.0)) continue;
    const double angle = std::atan2(sine, a.dot(b));
    sum.first += (0.5 * angle / sine) * cross;
    sum.second += (std::tan(0.5 * angle) / (3.0 * sine)) * (a + b) * cross.transpose();
  }
}

/// True if the polyhedron is on the far side of the cone. Decided by an edge that is a corner of
/// the hull of the edges as seen from `inner`, a direction inside the cone.
bool is_peak(std::span<const Vec3> edges, std::span<const double> exterior_angles,
             const Vec3& inner) {
  const Vec3 across = inner.unitOrthogonal();
  std::size_t corner = 0;
  double farthest = -1e300;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double depth = -inner.dot(edges[i]);
    const double position = across.dot(edges[i]) / std::max(depth, 1e-300);
    if (position > farthest) {
      farthest = position;
      corner = i;
    }
  }
  return exterior_angles[corner] > 0.0;
}

}  // namespace

NormalConeIntegrals integrate_normal_cone(std::span<const Vec3> edges,
                                          std::span<const double> exterior_angles) {
  NormalConeIntegrals cone;
  // Octant by octant: no polygon then has antipodal corners, whose arc would be undefined.
  for (int octant = 0; octant < 8; ++octant) {
    const double x = octant & 1 ? -1.0 : 1.0;
    const double y = octant & 2 ? -1.0 : 1.0;
    const double z = octant & 4 ? -1.0 : 1.0;
    Polygon polygon = {Vec3(x, 0, 0), Vec3(0, y, 0), Vec3(0, 0, z)};
    if (x * y * z < 0.0) std::swap(polygon[1], polygon[2]);
    for (const Vec3& e : edges) polygon = clipped(polygon, e);
    if (polygon.size() > 2) add_polygon(polygon, cone);
  }
  cone.second = (0.5 * (cone.second + cone.second.transpose())).eval();
  if (!(cone.solid_angle > 0.0) || !(cone.first.norm() > 0.0)) return NormalConeIntegrals{};
  return is_peak(edges, exterior_angles, cone.first.normalized()) ? cone : NormalConeIntegrals{};
}

}  // namespace clast::massprops_detail
