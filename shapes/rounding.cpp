#include "shapes/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "core/error.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/plane_quadric.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast {

namespace {

/// Share of the scan's volume that collapsing edges may lose before the radius counts as too large.
constexpr double kVolumeKept = 0.97;
/// Halvings and bisections in search of the largest radius that works, for the message.
constexpr int kRadiusHalvings = 12, kBisections = 6;

/// Every vertex moved so that the planes around it come in by `depth`. Weights by corner angle
/// don't depend on how a flat face is cut into triangles.
TriangleMesh inset(const TriangleMesh& mesh, double depth) {
  std::vector<PlaneQuadric> fits(mesh.vertices.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 normal = unit_normal(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      fits[t[k]].add_plane(normal, -depth, corner_angle(mesh, t, k));
    }
  }
  TriangleMesh result = mesh;
  for (std::size_t v = 0; v < fits.size(); ++v)
    result.vertices[v] += fits[v].step_to_intersection();
  return result;
}

std::vector<std::uint32_t> flipped(const TriangleMesh& before, const TriangleMesh& after) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t t = 0; t < before.triangles.size(); ++t) {
    const Vec3 old_normal = unit_normal(before, before.triangles[t]);
    const Vec3 new_normal = unit_normal(after, after.triangles[t]);
    if (!(old_normal.dot(new_normal) > 0.0)) result.push_back(t);
  }
  return result;
}

/// Triangles of pairs that cross, each once.
std::vector<std::uint32_t> crossing(const TriangleMesh& core) {
  std::vector<std::uint32_t> result;
  for (const auto& pair : find_self_intersections(core)) {
    result.insert(result.end(), pair.begin(), pair.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// The inset core, or none when the radius is too large for the scan.
std::optional<TriangleMesh> core_of(const TriangleMesh& scan, double radius) {
  const double volume = signed_volume(scan);
  TriangleMesh outer = scan;
  while (true) {
    TriangleMesh core = inset(outer, radius);
    if (std::abs(signed_volume(outer) - volume) > (1.0 - kVolumeKept) * volume) return std::nullopt;
    std::vector<std::uint32_t> bad = flipped(outer, core);
    if (bad.empty()) {
      if (!(signed_volume(core) > 0.0)) return std::nullopt;
      bad = crossing(core);
      if (bad.empty()) return core;
    }
    if (collapse_triangle_edges(outer, bad) == 0) return std::nullopt;
  }
}

double largest_radius(const TriangleMesh& scan, double too_large) {
  double high = too_large, low = 0.0;
  for (int i = 0; i < kRadiusHalvings && low == 0.0; ++i) {
    const double middle = 0.5 * high;
    (core_of(scan, middle) ? low : high) = middle;
  }
  for (int i = 0; i < kBisections && low > 0.0; ++i) {
    const double middle = 0.5 * (low + high);
    (core_of(scan, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::optional<SpheroPolyhedron> try_inset_core(const TriangleMesh& scan, double minkowski_radius) {
  const MeshReport report = inspect_mesh(scan);
  if (!report.is_closed() || !report.is_oriented()) {
    throw GeometryError("only a closed surface can be rounded; this one has " + report.summary());
  }
  if (!(signed_volume(scan) > 0.0)) {
    throw GeometryError(
        "only a surface that faces outwards can be rounded; this one faces inwards");
  }
  if (!(minkowski_radius > 0.0) || !std::isfinite(minkowski_radius)) {
    return make_sphero_polyhedron(scan, minkowski_radius);
  }
  const std::optional<TriangleMesh> core = core_of(scan, minkowski_radius);
  if (!core) return std::nullopt;
  return make_sphero_polyhedron(*core, minkowski_radius);
}

SpheroPolyhedron inset_core(const TriangleMesh& scan, double minkowski_radius) {
  if (std::optional<SpheroPolyhedron> core = try_inset_core(scan, minkowski_radius)) {
    return std::move(*core);
  }
  const double largest = largest_radius(scan, minkowski_radius);
  std::ostringstream message;
  message.precision(3);
  message << "a Minkowski radius of " << minkowski_radius << " m is too large for this block: ";
  if (largest > 0.0) {
    message << "its core would vanish or turn inside out; " << largest << " m works";
  } else if (!crossing(scan).empty()) {
    message << "smaller radii do not work either, because the surface intersects itself; repair it "
               "first, for example in MeshLab or CloudCompare";
  } else {
    message << "smaller radii do not work either; simplify the scan first";
  }
  throw GeometryError(message.str());
}

}  // namespace clast
