#include "terrain/detail/layers.hpp"

#include <algorithm>
#include <numeric>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/detail/plan_index.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kSmallComponent = 0.05;  // of the plan area of the largest component
constexpr double kNoRoom = 1e-6;          // m, between two faces, at least
constexpr double kMostlyOver = 0.9;       // of a component's plan area, beyond which it lies double
constexpr double kFoldedShare = 1e-3;     // of all plan area, under which folds are only noted

/// For every triangle that faces up, the one that faces up next over its centroid, if no face
/// between faces down; and the other way round. Also one that faces down and lies on it: an
/// overhang without room under it is the other side of a sheet that was joined round its border.
std::vector<std::uint32_t> doubles_of(const TriangleMesh& mesh, double width) {
  const std::vector<PlanBox> boxes = plan_boxes(mesh);
  const PlanIndex index(boxes);
  std::vector<std::uint32_t> twin(mesh.triangles.size(), kNoTriangle);
  struct Hit {
    double z;
    std::uint32_t triangle;
    bool up;
    bool operator<(const Hit& other) const {
      return z < other.z || (z == other.z && triangle < other.triangle);
    }
  };
  std::vector<Hit> hits;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!(area_vector(mesh, mesh.triangles[t]).z() > 0.0)) continue;
    const Vec3 middle = centroid(mesh, mesh.triangles[t]);
    hits.assign(1, {middle.z(), t, true});
    for (const std::uint32_t other : index.near(Vec2(middle.head<2>()))) {
      const PlanBox& box = boxes[other];
      if (other == t || middle.x() < box.low.x() || middle.y() < box.low.y() ||
          middle.x() > box.high.x() || middle.y() > box.high.y()) {
        continue;
      }
      const std::optional<double> z = height_on(mesh, other, middle.head<2>());
      if (z) hits.push_back({*z, other, area_vector(mesh, mesh.triangles[other]).z() > 0.0});
    }
    if (hits.size() == 1) continue;
    std::sort(hits.begin(), hits.end());
    for (std::size_t k = 0; k < hits.size(); ++k) {
      if (hits[k].triangle != t) continue;
      if (k + 1 < hits.size() && (hits[k + 1].up || hits[k + 1].z - hits[k].z <= width))
        twin[t] = hits[k + 1].triangle;
      if (k > 0 && hits[k - 1].up) twin[t] = hits[k - 1].triangle;
    }
  }
  return twin;
}

}  // namespace

void drop_double_ground(RawSurface& surface, double width, TerrainReport& report) {
  const TriangleMesh& mesh = surface.mesh;
  const std::vector<std::uint32_t> twin = doubles_of(mesh, std::max(width, kNoRoom));
  if (std::all_of(twin.begin(), twin.end(), [](std::uint32_t t) { return t == kNoTriangle; })) {
    return;
  }
  const std::vector<std::uint32_t> component = manifold_components(triangle_neighbours(mesh));
  const std::size_t count = *std::max_element(component.begin(), component.end()) + 1u;
  std::vector<double> area(count, 0.0), doubled(count, 0.0);
  for (std::uint32_t t = 0; t < twin.size(); ++t) {
    const double plan = std::max(0.0, area_vector(mesh, mesh.triangles[t]).z() / 2.0);
    area[component[t]] += plan;
    if (twin[t] != kNoTriangle && component[twin[t]] != component[t]) doubled[component[t]] += plan;
  }
  const double largest = *std::max_element(area.begin(), area.end());
  std::vector<bool> dropped(count, false);
  for (std::size_t p = 0; p < count; ++p) {
    dropped[p] = area[p] < kSmallComponent * largest && doubled[p] > kMostlyOver * area[p];
  }
  double folded = 0.0, dropped_area = 0.0;
  Vec3 folded_at = Vec3::Zero(), dropped_at = Vec3::Zero();
  std::vector<bool> keep(twin.size());
  for (std::uint32_t t = 0; t < twin.size(); ++t) {
    const double plan = area_vector(mesh, mesh.triangles[t]).z() / 2.0;
    keep[t] = !dropped[component[t]];
    if (!keep[t]) {
      if (dropped_area == 0.0) dropped_at = centroid(mesh, mesh.triangles[t]);
      dropped_area += plan;
    } else if (twin[t] != kNoTriangle && !dropped[component[twin[t]]]) {
      if (folded == 0.0) folded_at = centroid(mesh, mesh.triangles[t]);
      // Two that face up are each seen from the other.
      folded += area_vector(mesh, mesh.triangles[twin[t]]).z() > 0.0 ? plan / 2.0 : plan;
    }
  }
  const double all = std::accumulate(area.begin(), area.end(), 0.0);
  if (folded > kFoldedShare * all) {
    throw GeometryError("the ground lies double over " + with_digits(folded, 4) +
                        " m2, the first at " + place_on_map(folded_at) +
                        ": two surfaces face up over each other with no overhang between, or lie "
                        "on each other; remove one of the tiles, or the part of it that overlaps");
  }
  if (folded > 0.0) {
    report.notes.push_back("the ground folds over itself on " + with_digits(folded, 3) +
                           " m2, the first at " + place_on_map(folded_at));
  }
  const auto components_dropped =
      static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), true));
  if (components_dropped == 0) return;
  keep_triangles(surface, keep);
  report.dropped_pieces += components_dropped;
  report.boundary_edges = triangle_neighbours(mesh).border_edges;
  report.components -= components_dropped;
  report.notes.push_back(std::to_string(components_dropped) + " small components of " +
                         with_digits(dropped_area, 3) +
                         " m2 in plan that lie over other ground were dropped, the first at " +
                         place_on_map(dropped_at));
}

}  // namespace clast::terrain_detail
