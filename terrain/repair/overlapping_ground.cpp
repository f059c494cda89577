#include "terrain/repair/overlapping_ground.hpp"

#include <algorithm>
#include <numeric>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/plan_index.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kSmallComponent = 0.05;  // of the plan area of the largest component
constexpr double kNoRoom = 1e-6;          // m, between two faces, at least
constexpr double kMostlyOver = 0.9;       // of a component's plan area, beyond which it lies double
constexpr double kFoldedFraction = 1e-3;  // of all plan area, under which folds are only noted

/// Finds for each upward triangle the next upward triangle above its centroid, if no triangle
/// between them faces down; and vice versa. Includes a downward triangle that coincides with it: an
/// overhang without space below is the back of a sheet joined around its border.
std::vector<std::uint32_t> doubles_of(const TriangleMesh& mesh, double width) {
  const std::vector<PlanBox> boxes = plan_boxes(mesh);
  const PlanIndex index(boxes);
  std::vector<std::uint32_t> twin(mesh.triangles.size(), kNoIndex);
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
    if (!(doubled_area_vector(mesh, mesh.triangles[t]).z() > 0.0)) continue;
    const Vec3 middle = centroid(mesh, mesh.triangles[t]);
    hits.assign(1, {middle.z(), t, true});
    for (const std::uint32_t other : index.boxes_near(Vec2(middle.head<2>()))) {
      const PlanBox& box = boxes[other];
      if (other == t || middle.x() < box.low.x() || middle.y() < box.low.y() ||
          middle.x() > box.high.x() || middle.y() > box.high.y()) {
        continue;
      }
      const std::optional<double> z = height_on_triangle(mesh, other, middle.head<2>());
      if (z)
        hits.push_back({*z, other, doubled_area_vector(mesh, mesh.triangles[other]).z() > 0.0});
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

struct Components {
  std::vector<std::uint32_t> of;   ///< each triangle
  std::vector<double> area;        ///< in plan, m2
  std::vector<bool> dropped = {};  ///< small ones that lie over others
};

Components components_over_others(const TriangleMesh& mesh,
                                  const std::vector<std::uint32_t>& twin) {
  Components result{manifold_components(triangle_neighbours(mesh)), {}};
  const std::size_t count = *std::max_element(result.of.begin(), result.of.end()) + 1u;
  result.area.assign(count, 0.0);
  std::vector<double> doubled(count, 0.0);
  for (std::uint32_t t = 0; t < twin.size(); ++t) {
    const std::uint32_t here = result.of[t];
    const double plan = std::max(0.0, doubled_area_vector(mesh, mesh.triangles[t]).z() / 2.0);
    result.area[here] += plan;
    if (twin[t] != kNoIndex && result.of[twin[t]] != here) doubled[here] += plan;
  }
  const double largest = *std::max_element(result.area.begin(), result.area.end());
  for (std::size_t p = 0; p < count; ++p) {
    result.dropped.push_back(result.area[p] < kSmallComponent * largest &&
                             doubled[p] > kMostlyOver * result.area[p]);
  }
  return result;
}

/// An area in plan, and its first place.
struct PlanArea {
  double m2 = 0.0;
  Vec3 first = Vec3::Zero();

  void add(double area, const Vec3& place) {
    if (m2 == 0.0) first = place;
    m2 += area;
  }
};

/// Ground over ground that stays is refused, or noted where it is little.
void check_folded(const PlanArea& folded, double whole, TerrainReport& report) {
  if (folded.m2 > kFoldedFraction * whole) {
    throw GeometryError(
        "the ground has two surfaces over " + format_significant(folded.m2, 4) +
        " m2, the first at " + format_map_point(folded.first) +
        ": two upward-facing surfaces lie above each other without an overhang between them, or "
        "coincide; remove one of the tiles, or the part of it that overlaps");
  }
  if (folded.m2 > 0.0) {
    report.notes.push_back("the ground folds over itself on " + format_significant(folded.m2, 3) +
                           " m2, the first at " + format_map_point(folded.first));
  }
}

}  // namespace

void remove_overlapping_ground(RawSurface& surface, double width, TerrainReport& report) {
  const TriangleMesh& mesh = surface.mesh;
  const std::vector<std::uint32_t> twin = doubles_of(mesh, std::max(width, kNoRoom));
  if (std::all_of(twin.begin(), twin.end(), [](std::uint32_t t) { return t == kNoIndex; })) {
    return;
  }
  const Components component = components_over_others(mesh, twin);
  const auto is_dropped = [&](std::uint32_t t) -> bool {
    return component.dropped[component.of[t]];
  };
  PlanArea folded, dropped;
  std::vector<bool> keep(twin.size());
  for (std::uint32_t t = 0; t < twin.size(); ++t) {
    const double plan = doubled_area_vector(mesh, mesh.triangles[t]).z() / 2.0;
    keep[t] = !is_dropped(t);
    if (!keep[t]) {
      dropped.add(plan, centroid(mesh, mesh.triangles[t]));
    } else if (twin[t] != kNoIndex && !is_dropped(twin[t])) {
      // Two that face up are each seen from the other.
      const bool seen_twice = doubled_area_vector(mesh, mesh.triangles[twin[t]]).z() > 0.0;
      folded.add(seen_twice ? plan / 2.0 : plan, centroid(mesh, mesh.triangles[t]));
    }
  }
  check_folded(folded, std::accumulate(component.area.begin(), component.area.end(), 0.0), report);
  const auto count = static_cast<std::size_t>(
      std::count(component.dropped.begin(), component.dropped.end(), true));
  if (count == 0) return;
  retain_triangles(surface, keep);
  report.removed_components += count;
  report.boundary_edges = triangle_neighbours(mesh).border_edges;
  report.components -= count;
  report.notes.push_back(std::to_string(count) + " small components of " +
                         format_significant(dropped.m2, 3) +
                         " m2 in plan that lie over other ground were removed, the first at " +
                         format_map_point(dropped.first));
}

}  // namespace clast::terrain_detail
