#include <algorithm>
#include <map>
#include <utility>

#include "mesh/mesh_topology.hpp"
#include "mesh/plan_geometry.hpp"
#include "terrain/detail/surface_overlay.hpp"

namespace clast::terrain_detail {
namespace {

using Triangle = TriangleMesh::Triangle;

/// An outline crosses edges no nearer to their ends than this, m, so that it never passes through a
/// vertex and no body touches itself there; of shorter edges, than a quarter of them.
constexpr double kMinDistance = 1e-5;
constexpr double kMaxFraction = 0.25;
/// Less is rounding, m.
constexpr double kNoThickness = 1e-5;

/// The part of a pair that is thick enough.
struct ThickPart {
  SurfaceOverlay pair;
  std::vector<bool> on_outline;  ///< of every vertex: the thickness falls to the limit there
};

class Outlining {
 public:
  Outlining(const SurfaceOverlay& pair, double thickness) : from_(pair), thickness_(thickness) {}

  ThickPart part() {
    for (const Triangle& triangle : from_.triangles) add(triangle);
    return std::move(part_);
  }

 private:
  bool thick(std::uint32_t vertex) const {
    return from_.thickness(vertex) > std::max(thickness_, kNoThickness);
  }

  void add(const Triangle& corners) {
    const auto count =
        std::count_if(corners.begin(), corners.end(), [this](std::uint32_t v) { return thick(v); });
    if (count == 0) return;
    // Turned so that the odd one out comes first.
    std::size_t first = 0;
    if (count < 3) {
      while (thick(corners[first]) != (count == 1)) ++first;
    }
    const std::uint32_t a = corners[first], b = corners[(first + 1) % 3],
                        c = corners[(first + 2) % 3];
    std::vector<Triangle>& kept = part_.pair.triangles;
    if (count == 3) {
      kept.push_back({vertex(a), vertex(b), vertex(c)});
    } else if (count == 1) {
      const std::uint32_t to_b = crossing(a, b), to_c = crossing(a, c);
      kept.push_back({vertex(a), to_b, to_c});
    } else {
      const std::uint32_t from_b = crossing(b, a), from_c = crossing(c, a);
      const std::uint32_t kept_b = vertex(b), kept_c = vertex(c);
      kept.push_back({from_b, kept_b, kept_c});
      kept.push_back({from_b, kept_c, from_c});
    }
  }

  std::uint32_t vertex(std::uint32_t v) {
    const auto [entry, fresh] = vertices_.try_emplace(v, 0);
    if (fresh) entry->second = append(from_.plan[v], from_.top[v], from_.base[v], false);
    return entry->second;
  }

  /// Between a thick vertex and one that is not.
  std::uint32_t crossing(std::uint32_t in, std::uint32_t out) {
    const auto [entry, fresh] = crossings_.try_emplace({in, out}, 0);
    if (!fresh) return entry->second;
    const double inner = from_.thickness(in), outer = from_.thickness(out);
    const double length = (from_.plan[out] - from_.plan[in]).norm();
    const double least =
        kMinDistance < kMaxFraction * length ? kMinDistance / length : kMaxFraction;
    const double share = std::clamp((inner - thickness_) / (inner - outer), least, 1.0 - least);
    const Vec2 plan = from_.plan[in] + share * (from_.plan[out] - from_.plan[in]);
    double top = from_.top[in] + share * (from_.top[out] - from_.top[in]);
    double base = from_.base[in] + share * (from_.base[out] - from_.base[in]);
    if (thickness_ == 0.0) top = base = 0.5 * (top + base);
    return entry->second = append(plan, top, base, true);
  }

  std::uint32_t append(const Vec2& plan, double top, double base, bool on_outline) {
    part_.pair.plan.push_back(plan);
    part_.pair.top.push_back(top);
    part_.pair.base.push_back(base);
    part_.on_outline.push_back(on_outline);
    return static_cast<std::uint32_t>(part_.pair.plan.size() - 1);
  }

  const SurfaceOverlay& from_;
  double thickness_;
  ThickPart part_;
  std::map<std::uint32_t, std::uint32_t> vertices_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
};

/// The closed surface over and below some triangles of a pair.
class Closing {
 public:
  Closing(const ThickPart& part, const std::vector<Triangle>& triangles)
      : part_(part), triangles_(triangles) {}

  BodyBetweenSurfaces body() {
    for (const Triangle& triangle : triangles_) {
      add({top(triangle[0]), top(triangle[1]), top(triangle[2])});
      measure(triangle);
    }
    body_.top_triangles = body_.mesh.triangles.size();
    for (const Triangle& triangle : triangles_) {
      add({base(triangle[2]), base(triangle[1]), base(triangle[0])});
    }
    add_walls();
    return std::move(body_);
  }

 private:
  void add(const Triangle& triangle) { body_.mesh.triangles.push_back(triangle); }

  std::uint32_t top(std::uint32_t v) { return numbered(tops_, v, part_.pair.top[v]); }
  std::uint32_t base(std::uint32_t v) {
    const bool one = part_.on_outline[v] && part_.pair.top[v] == part_.pair.base[v];
    return one ? top(v) : numbered(bases_, v, part_.pair.base[v]);
  }

  std::uint32_t numbered(std::map<std::uint32_t, std::uint32_t>& numbers, std::uint32_t v,
                         double height) {
    const auto [entry, fresh] =
        numbers.try_emplace(v, static_cast<std::uint32_t>(body_.mesh.vertices.size()));
    if (fresh) {
      body_.mesh.vertices.emplace_back(part_.pair.plan[v].x(), part_.pair.plan[v].y(), height);
    }
    return entry->second;
  }

  void measure(const Triangle& triangle) {
    const SurfaceOverlay& pair = part_.pair;
    body_.plan_area +=
        0.5 * twice_area(pair.plan[triangle[0]], pair.plan[triangle[1]], pair.plan[triangle[2]]);
    for (const std::uint32_t v : triangle) {
      body_.max_thickness = std::max(body_.max_thickness, pair.thickness(v));
    }
  }

  /// Marks a side without an adjacent triangle.
  void add_walls() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> sides;
    for (const Triangle& triangle : triangles_) {
      for (std::size_t k = 0; k < 3; ++k) sides[{triangle[k], triangle[(k + 1) % 3]}] = true;
    }
    for (const auto& [side, unused] : sides) {
      const auto [a, b] = side;
      if (sides.contains({b, a})) continue;
      const std::uint32_t top_a = top(a), top_b = top(b), base_a = base(a), base_b = base(b);
      if (top_a != base_a) add({top_b, top_a, base_a});
      if (top_b != base_b) add({top_b, base_a, base_b});
      for (const std::uint32_t v : {a, b}) {
        if (part_.pair.thickness(v) <= body_.max_wall_height) continue;
        body_.max_wall_height = part_.pair.thickness(v);
        body_.wall_position = body_.mesh.vertices[top(v)];
      }
    }
  }

  const ThickPart& part_;
  const std::vector<Triangle>& triangles_;
  std::map<std::uint32_t, std::uint32_t> tops_, bases_;
  BodyBetweenSurfaces body_;
};

}  // namespace

std::vector<BodyBetweenSurfaces> extract_bodies_between(const SurfaceOverlay& pair,
                                                        double thickness) {
  const ThickPart part = Outlining(pair, thickness).part();
  if (part.pair.triangles.empty()) return {};
  TriangleMesh plan;
  for (const Vec2& place : part.pair.plan) plan.vertices.emplace_back(place.x(), place.y(), 0.0);
  plan.triangles = part.pair.triangles;
  const std::vector<std::uint32_t> component = triangle_components(plan);
  std::vector<std::vector<Triangle>> triangles(
      *std::max_element(component.begin(), component.end()) + 1);
  for (std::size_t t = 0; t < component.size(); ++t) {
    triangles[component[t]].push_back(plan.triangles[t]);
  }
  std::vector<BodyBetweenSurfaces> bodies;
  for (const std::vector<Triangle>& each : triangles) bodies.push_back(Closing(part, each).body());
  return bodies;
}

}  // namespace clast::terrain_detail
