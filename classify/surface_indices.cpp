#include "classify/surface_indices.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "massprops/sphero.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/mesh_topology.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

/// Integral of n n^T per length and radius over the cylinder between two face normals.
Mat3 wedge(const Vec3& n1, const Vec3& n2, double bend) {
  const Vec3 w = (n1 + n2).normalized();
  const Vec3 across = (n2 - n1);
  const double length = across.norm();
  // Flat: the wedge has no width.
  if (!(length > 0.0)) return Mat3::Zero();
  const Vec3 y = across / length;
  return 0.5 * (bend + std::sin(bend)) * w * w.transpose() +
         0.5 * (bend - std::sin(bend)) * y * y.transpose();
}

/// Integral of n n^T over the core's faces, and what rounding adds along the edges.
/// @param core  closed and oriented: every edge has one side in each direction
Mat3 orientation_integral(const TriangleMesh& core, double radius) {
  std::vector<Vec3> normals;
  Mat3 sum = Mat3::Zero();
  for (const auto& [a, b, c] : core.triangles) {
    const Vec3 cross =
        (core.vertices[b] - core.vertices[a]).cross(core.vertices[c] - core.vertices[a]);
    normals.push_back(cross.normalized());
    if (cross.squaredNorm() > 0.0) sum += 0.5 * cross * normals.back().transpose();
  }
  for_each_edge(sorted_half_edges(core), [&](std::span<const HalfEdge> sides) {
    const bool forward = sides[0].is_forward;
    const Vec3 edge = core.vertices[sides[0].high] - core.vertices[sides[0].low];
    const Vec3& n1 = normals[sides[forward ? 0 : 1].triangle];
    const Vec3& n2 = normals[sides[forward ? 1 : 0].triangle];
    const double length = edge.norm();
    const double bend = std::atan2(edge.dot(n1.cross(n2)) / length, n1.dot(n2));
    if (bend > 0.0) {
      sum += radius * length * wedge(n1, n2, bend);
    } else if (bend < 0.0) {
      // The strips of the two faces end where they meet.
      const double width = radius * std::tan(-0.5 * bend);
      sum -= length * width * (n1 * n1.transpose() + n2 * n2.transpose());
    }
  });
  return sum;
}

}  // namespace

double true_sphericity(double volume, double area) {
  return std::cbrt(kPi) * std::pow(6.0 * volume, 2.0 / 3.0) / area;
}

double convexity(const SpheroPolyhedron& body, double volume) {
  if (body.faces.empty()) return 1.0;  // a ball or a capsule
  const SpheroPolyhedron hull = make_sphero_polyhedron(convex_hull(body.vertices), body.radius);
  // Not the sum for convex cores: points off a flat wall by rounding leave edges that are reflex by
  // a hair in the triangles of a hull.
  return volume / sphero_mass_properties(hull, 1.0).volume;
}

OrientationTensor orientation_tensor(const SpheroPolyhedron& body) {
  const double r = body.radius;
  Mat3 integral = 4.0 * kPi / 3.0 * r * r * Mat3::Identity();
  if (!body.faces.empty()) {
    const TriangleMesh core = core_mesh(body);
    const MeshReport report = inspect_mesh(core);
    if (!report.is_closed() || !report.is_oriented()) {
      throw GeometryError("surface orientation: the core is not a closed surface: " +
                          report.summary());
    }
    integral += orientation_integral(core, r);
  }
  const double area = integral.trace();
  if (!(area > 0.0)) throw GeometryError("surface orientation: the body has no surface");
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(integral / area, Eigen::EigenvaluesOnly);
  return {eigen.eigenvalues().reverse()};
}

std::span<const SurfaceIndex> surface_index_definitions() {
  static constexpr std::array<SurfaceIndex, 5> list = {
      {{"wadell_true_sphericity", "pi^(1/3) (6 V)^(2/3)/A", "wadell1932"},
       {"convexity", "V/V_hull, both rounded", ""},
       {"bagi_orosz_compactness", "f3/f1, surface orientation", "bagi2020"},
       {"bagi_orosz_flakiness", "(f1 - f2)/f1, surface orientation", "bagi2020"},
       {"bagi_orosz_rodness", "(f2 - f3)/f1, surface orientation", "bagi2020"}}};
  return list;
}

std::map<std::string, double> surface_indices(const SpheroPolyhedron& body, double volume,
                                              double area) {
  std::map<std::string, double> indices = {
      {"wadell_true_sphericity", true_sphericity(volume, area)},
      {"convexity", convexity(body, volume)}};
  try {
    const OrientationTensor orientation = orientation_tensor(body);
    indices["bagi_orosz_compactness"] = orientation.compactness();
    indices["bagi_orosz_flakiness"] = orientation.flakiness();
    indices["bagi_orosz_rodness"] = orientation.rodness();
  } catch (const GeometryError&) {
    // A narrow tunnel does not invalidate the other indices.
  }
  return indices;
}

}  // namespace clast
