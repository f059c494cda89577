#include "terrain/detail/surface_overlay.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "mesh/half_edges.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_geometry.hpp"
#include "terrain/plan_clip.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/zones/zone_cut.hpp"

namespace clast::terrain_detail {
namespace {

/// Heights over one vertex that differ by more are of two sides of a step, m: more than what joined
/// edges do on ground as steep as ground is.
constexpr double kSameHeight = 1e-3;

using Triangle = TriangleMesh::Triangle;

/// The height of a triangle's plane over a place.
double plane_height(const TriangleMesh& mesh, const Triangle& triangle, const Vec2& at) {
  const Vec3& corner = mesh.vertices[triangle[0]];
  const Vec3 normal = doubled_area_vector(mesh, triangle);
  return corner.z() - normal.head<2>().dot(at - corner.head<2>()) / normal.z();
}

PlanTriangle paired_plan_triangle(const TriangleMesh& mesh, const Triangle& triangle) {
  return {mesh.vertices[triangle[0]].head<2>(), mesh.vertices[triangle[1]].head<2>(),
          mesh.vertices[triangle[2]].head<2>()};
}

/// Lowest and highest corner of every triangle.
std::vector<std::array<double, 2>> height_spans(const TriangleMesh& mesh) {
  std::vector<std::array<double, 2>> spans;
  for (const Triangle& triangle : mesh.triangles) {
    const auto [low, high] =
        std::minmax({mesh.vertices[triangle[0]].z(), mesh.vertices[triangle[1]].z(),
                     mesh.vertices[triangle[2]].z()});
    spans.push_back({low, high});
  }
  return spans;
}

/// The triangles that face up and, where there are outlines, lie near one.
TriangleMesh upper_side(const TriangleMesh& mesh, std::span<const ZonePolygon> outlines) {
  std::vector<Triangle> kept;
  for (const Triangle& triangle : mesh.triangles) {
    if (!(doubled_area_vector(mesh, triangle).z() > 0.0)) continue;
    PlanBox box;
    for (const std::uint32_t v : triangle) box.include(mesh.vertices[v].head<2>());
    const bool near = std::any_of(outlines.begin(), outlines.end(), [&](const ZonePolygon& each) {
      return (each.low.array() <= box.high.array()).all() &&
             (box.low.array() <= each.high.array()).all();
    });
    if (near || outlines.empty()) kept.push_back(triangle);
  }
  return extract_triangles(mesh, kept);
}

/// Calls `visit(t, b, corner, thickness)` for every corner of what triangle t of `top` and triangle
/// b of `base` have in common in plan, of pairs that may be more than `thickness` apart.
void each_common_corner(
    const TriangleMesh& top, const TriangleMesh& base, double thickness,
    const std::function<void(std::uint32_t, std::uint32_t, const Vec2&, double)>& visit) {
  const std::vector<PlanBox> boxes = plan_boxes(top), base_boxes = plan_boxes(base);
  const std::vector<std::array<double, 2>> top_spans = height_spans(top),
                                           base_spans = height_spans(base);
  const PlanIndex index(base_boxes);
  for (std::uint32_t t = 0; t < top.triangles.size(); ++t) {
    const PlanTriangle ring = paired_plan_triangle(top, top.triangles[t]);
    for (const std::uint32_t b : index.boxes_near(boxes[t])) {
      if (top_spans[t][1] - base_spans[b][0] <= thickness) continue;
      if ((base_boxes[b].low.array() > boxes[t].high.array()).any() ||
          (boxes[t].low.array() > base_boxes[b].high.array()).any()) {
        continue;
      }
      for (const Vec2& corner :
           clip_to_triangle(ring, paired_plan_triangle(base, base.triangles[b]))) {
        visit(t, b, corner,
              plane_height(top, top.triangles[t], corner) -
                  plane_height(base, base.triangles[b], corner));
      }
    }
  }
}

/// Every edge of a mesh once, in plan.
void append_edges(const TriangleMesh& mesh, std::vector<std::array<Vec2, 2>>& segments) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
      edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    segments.push_back({mesh.vertices[a].head<2>(), mesh.vertices[b].head<2>()});
  }
}

void append_edges(std::span<const ZonePolygon> outlines,
                  std::vector<std::array<Vec2, 2>>& segments) {
  for (const ZonePolygon& outline : outlines) {
    for (const std::vector<Vec2>& ring : outline.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
      }
    }
  }
}

/// A triangle of the divided surface with the one of the other surface over or below it.
struct Match {
  Triangle corners;
  std::uint32_t other;
};

std::vector<Match> matched(const TriangleMesh& divided, const TriangleMesh& other,
                           std::span<const ZonePolygon> outlines) {
  const PlanIndex index(plan_boxes(other));
  std::vector<Match> matches;
  for (const Triangle& triangle : divided.triangles) {
    const Vec2 middle = centroid(divided, triangle).head<2>();
    const bool inside =
        outlines.empty() || std::any_of(outlines.begin(), outlines.end(),
                                        [&](const auto& each) { return each.contains(middle); });
    if (!inside || !(doubled_area_vector(divided, triangle).z() > 0.0)) continue;
    double highest = -1e300;
    std::optional<std::uint32_t> found;
    for (const std::uint32_t o : index.boxes_near(middle)) {
      const std::optional<double> z = height_on_triangle(other, o, middle);
      if (!z || *z <= highest) continue;
      highest = *z;
      found = o;
    }
    if (found) matches.push_back({triangle, *found});
  }
  return matches;
}

/// Adds the other surface's heights at the corners of matches; duplicates vertices over its steps.
SurfaceOverlay with_other_heights(const TriangleMesh& divided, const TriangleMesh& other,
                                  const std::vector<Match>& matches, bool divided_is_top) {
  struct Corner {
    std::uint32_t vertex;
    double height;
    std::uint32_t match, k;
  };
  std::vector<Corner> corners;
  for (std::uint32_t m = 0; m < matches.size(); ++m) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = matches[m].corners[k];
      const double z =
          plane_height(other, other.triangles[matches[m].other], divided.vertices[v].head<2>());
      corners.push_back({v, z, m, k});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.vertex, a.height, a.match) < std::tie(b.vertex, b.height, b.match);
  });
  SurfaceOverlay pair;
  pair.triangles.resize(matches.size());
  for (std::size_t i = 0; i < corners.size();) {
    std::size_t end = i + 1;
    while (end < corners.size() && corners[end].vertex == corners[i].vertex &&
           corners[end].height - corners[end - 1].height <= kSameHeight) {
      ++end;
    }
    const Vec3& vertex = divided.vertices[corners[i].vertex];
    const double height = 0.5 * (corners[i].height + corners[end - 1].height);
    for (std::size_t j = i; j < end; ++j) {
      pair.triangles[corners[j].match][corners[j].k] = static_cast<std::uint32_t>(pair.plan.size());
    }
    pair.plan.emplace_back(vertex.head<2>());
    pair.top.push_back(divided_is_top ? vertex.z() : height);
    pair.base.push_back(divided_is_top ? height : vertex.z());
    i = end;
  }
  return pair;
}

}  // namespace

SurfaceOverlay overlay_surfaces(const TriangleMesh& top, const TriangleMesh& base, double thickness,
                                std::span<const ZonePolygon> outlines) {
  const TriangleMesh upper = upper_side(top, outlines), lower = upper_side(base, outlines);
  std::vector<bool> of_upper(upper.triangles.size()), of_lower(lower.triangles.size());
  each_common_corner(upper, lower, thickness,
                     [&](std::uint32_t t, std::uint32_t b, const Vec2&, double apart) {
                       if (apart > thickness) of_upper[t] = of_lower[b] = true;
                     });
  TriangleMesh one = extract_triangles(upper, of_upper), two = extract_triangles(lower, of_lower);
  // Many small triangles are quicker to divide than few large ones into many.
  const bool top_is_finer = one.triangles.size() > two.triangles.size();
  TriangleMesh &divided = top_is_finer ? one : two, &other = top_is_finer ? two : one;
  std::vector<std::array<Vec2, 2>> segments;
  append_edges(other, segments);
  append_edges(outlines, segments);
  insert_edges_along_segments(divided, segments);
  return with_other_heights(divided, other, matched(divided, other, outlines), top_is_finer);
}

HeightDifferenceRange height_difference_range(const TriangleMesh& top, const TriangleMesh& base) {
  const TriangleMesh upper = upper_side(top, {}), lower = upper_side(base, {});
  HeightDifferenceRange range;
  each_common_corner(
      upper, lower, -1e300, [&](std::uint32_t t, std::uint32_t, const Vec2& corner, double apart) {
        const auto at = [&] {
          return Vec3(corner.x(), corner.y(), plane_height(upper, upper.triangles[t], corner));
        };
        if (apart < range.low) range.low = apart, range.low_position = at();
        if (apart > range.high) range.high = apart, range.high_position = at();
      });
  return range;
}

}  // namespace clast::terrain_detail
