#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "shapes/detail/triangle_tree.hpp"
#include "shapes/rounding.hpp"

namespace clast {

namespace {

constexpr std::uint64_t kSeed = 20220906;  ///< any fixed number: same shapes, same samples
/// Share of the radius by which a sample may lie inside the body and still count as on its skin.
constexpr double kOnSkin = 1e-9;

/// Points spread evenly over the area: one per equal share of it, at a random place there.
std::vector<Vec3> spread_points(const TriangleMesh& mesh, std::size_t count) {
  std::vector<double> doubled_areas;
  double total = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    doubled_areas.push_back((mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                                .norm());
    total += doubled_areas.back();
  }
  Random random(kSeed);
  std::vector<Vec3> points;
  double passed = 0.0;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted =
        total * (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    while (triangle + 1 < doubled_areas.size() && passed + doubled_areas[triangle] < wanted) {
      passed += doubled_areas[triangle++];
    }
    const double root = std::sqrt(random.uniform()), along = random.uniform();
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    points.push_back((1.0 - root) * mesh.vertices[t[0]] +
                     root * (1.0 - along) * mesh.vertices[t[1]] +
                     root * along * mesh.vertices[t[2]]);
  }
  return points;
}

/// Points on the outer surface of the body: those of its skin mesh brought to the exact distance
/// from the core; what lies inside the body, as where pieces cross at reflex edges, is left out.
std::vector<Vec3> points_on_body(const SpheroPolyhedron& body, const detail::TriangleTree& core,
                                 std::size_t count) {
  const TriangleMesh skin = skin_mesh(body);
  std::vector<Vec3> candidates = spread_points(skin, count);
  candidates.insert(candidates.end(), skin.vertices.begin(), skin.vertices.end());
  if (body.radius == 0.0) return candidates;
  std::vector<Vec3> points;
  for (const Vec3& candidate : candidates) {
    const Vec3 foot = core.closest(candidate).point;
    const Vec3 away = candidate - foot;
    if (!(away.norm() > 0.0)) continue;
    const Vec3 point = foot + body.radius / away.norm() * away;
    if (core.signed_distance(point) >= (1.0 - kOnSkin) * body.radius) points.push_back(point);
  }
  return points;
}

}  // namespace

Deviation surface_deviation(const TriangleMesh& scan, const SpheroPolyhedron& body,
                            std::size_t samples) {
  if (scan.triangles.empty() || body.faces.empty()) {
    throw GeometryError("a deviation needs two surfaces; the " +
                        std::string(scan.triangles.empty() ? "scan" : "body") + " has none");
  }
  const TriangleMesh core = core_mesh(body);
  const detail::TriangleTree scan_tree(scan), core_tree(core);
  const auto to_body = [&](const Vec3& point) {
    return std::abs(core_tree.signed_distance(point) - body.radius);
  };

  Deviation result;
  const std::vector<Vec3> on_scan = spread_points(scan, std::max<std::size_t>(samples, 1));
  double sum = 0.0;
  for (const Vec3& point : on_scan) {
    const double distance = to_body(point);
    sum += distance;
    result.hausdorff = std::max(result.hausdorff, distance);
  }
  result.mean = sum / static_cast<double>(on_scan.size());
  // Corners stick out farthest.
  for (const Vec3& vertex : scan.vertices) {
    result.hausdorff = std::max(result.hausdorff, to_body(vertex));
  }
  for (const Vec3& point : points_on_body(body, core_tree, std::max<std::size_t>(samples, 1))) {
    result.hausdorff =
        std::max(result.hausdorff, std::sqrt(scan_tree.closest(point).squared_distance));
  }
  return result;
}

}  // namespace clast
