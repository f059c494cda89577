#include "reconstruct/repair/hole_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/vertex_corners.hpp"

namespace clast::reconstruct_detail {

namespace {

using Triangle = TriangleMesh::Triangle;

/// Fans of one sheet may overlap by this much around a vertex of a rough surface, rad.
constexpr double kOverlap = 0.35;

/// A border side, as the triangle beside it runs, and the fans of that triangle at both its ends.
struct BorderSide {
  std::uint32_t from, to;
  std::uint32_t fan_from, fan_to;
};

std::vector<BorderSide> border_sides(std::span<const HalfEdge> sorted,
                                     const std::vector<std::uint32_t>& fans) {
  std::vector<BorderSide> sides;
  for_each_edge(sorted, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 1) return;
    const std::uint32_t at_from = 3 * edge[0].triangle + edge[0].side;
    const std::uint32_t at_to = 3 * edge[0].triangle + (edge[0].side + 1) % 3;
    sides.push_back({edge[0].from(), edge[0].to(), fans[at_from], fans[at_to]});
  });
  return sides;
}

/// An open fan at a vertex: counter-clockwise from `starts` to `ends`, both numbers of
/// border sides, the first of which leaves the vertex and the second comes to it.
struct OpenFan {
  std::uint32_t fan = 0;
  std::uint32_t starts = kNoIndex, ends = kNoIndex;
  Vec3 normal = Vec3::Zero();  ///< doubled area of its triangles
  double from = 0.0, extent = 0.0;
};

/// The fans at one vertex in the order in which they stand around it; empty when they overlap.
std::vector<OpenFan> in_order(const TriangleMesh& mesh, std::uint32_t vertex,
                              std::vector<OpenFan> fans, const std::vector<BorderSide>& sides,
                              const std::vector<std::vector<std::uint32_t>>& triangles_of) {
  Vec3 normal = Vec3::Zero();
  for (const OpenFan& fan : fans) normal += fan.normal;
  if (!(normal.norm() > 0.0)) return {};
  normal.normalize();
  const Vec3& middle = mesh.vertices[vertex];
  Vec3 x = mesh.vertices[sides[fans[0].starts].to] - middle;
  x -= x.dot(normal) * normal;
  if (!(x.norm() > 0.0)) return {};
  x.normalize();
  const Vec3 y = normal.cross(x);
  const auto angle_to = [&](std::uint32_t v) {
    const Vec3 to = mesh.vertices[v] - middle;
    return std::atan2(to.dot(y), to.dot(x));
  };
  for (std::size_t i = 0; i < fans.size(); ++i) {
    fans[i].from = angle_to(sides[fans[i].starts].to);
    if (fans[i].from < 0.0) fans[i].from += 2.0 * kPi;
    for (const std::uint32_t t : triangles_of[i]) {
      const Triangle& corners = mesh.triangles[t];
      const int k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
      double angle_step = angle_to(corners[(k + 2) % 3]) - angle_to(corners[(k + 1) % 3]);
      if (angle_step < -kPi) angle_step += 2.0 * kPi;
      if (angle_step > kPi) angle_step -= 2.0 * kPi;
      fans[i].extent += angle_step;
    }
    if (fans[i].extent <= 0.0) return {};
  }
  std::sort(fans.begin(), fans.end(),
            [](const OpenFan& a, const OpenFan& b) { return a.from < b.from; });
  for (std::size_t i = 0; i < fans.size(); ++i) {
    const double next = i + 1 < fans.size() ? fans[i + 1].from : fans[0].from + 2.0 * kPi;
    if (fans[i].from + fans[i].extent > next + kOverlap) return {};
  }
  return fans;
}

/// A side of the border at one of its ends.
using SideEnd =
    std::array<std::uint32_t, 3>;  ///< vertex, fan, side; one that arrives: side + count

/// Returns the end of the range from `begin` at the same vertex.
std::size_t end_of_vertex(const std::vector<SideEnd>& ends, std::size_t begin) {
  std::size_t end = begin;
  while (end < ends.size() && ends[end][0] == ends[begin][0]) ++end;
  return end;
}

/// Triangles of the fans at vertices with more than one fan.
class TrianglesOfFans {
 public:
  TrianglesOfFans(const std::vector<SideEnd>& ends, const std::vector<std::uint32_t>& fans)
      : number_(fans.size(), kNoIndex) {
    for (std::size_t begin = 0, end; begin < ends.size(); begin = end) {
      end = end_of_vertex(ends, begin);
      if (end - begin <= 2) continue;
      for (std::size_t i = begin; i < end; ++i) number_[ends[i][1]] = 0;
    }
    std::uint32_t count = 0;
    for (std::uint32_t& n : number_) {
      if (n != kNoIndex) n = count++;
    }
    triangles_.resize(count);
    for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
      const std::uint32_t n = number_[fans[corner]];
      if (n != kNoIndex) triangles_[n].push_back(corner / 3);
    }
  }

  const std::vector<std::uint32_t>& of(std::uint32_t fan) const { return triangles_[number_[fan]]; }

 private:
  std::vector<std::uint32_t> number_;
  std::vector<std::vector<std::uint32_t>> triangles_;
};

/// Returns, for each border side that leaves its first vertex, the side at which the border
/// continues: the one at the end of the previous fan around the vertex.
std::vector<std::uint32_t> followers(const TriangleMesh& mesh, const std::vector<BorderSide>& sides,
                                     const std::vector<std::uint32_t>& fans) {
  std::vector<std::uint32_t> follower(sides.size(), kNoIndex);
  std::vector<SideEnd> ends;
  const auto count = static_cast<std::uint32_t>(sides.size());
  for (std::uint32_t s = 0; s < count; ++s) {
    ends.push_back({sides[s].from, sides[s].fan_from, s});
    ends.push_back({sides[s].to, sides[s].fan_to, s + count});
  }
  std::sort(ends.begin(), ends.end());
  const TrianglesOfFans triangles_of(ends, fans);
  for (std::size_t begin = 0, end; begin < ends.size(); begin = end) {
    end = end_of_vertex(ends, begin);
    std::vector<OpenFan> here;
    for (std::size_t i = begin; i < end; ++i) {
      if (here.empty() || here.back().fan != ends[i][1]) here.push_back({ends[i][1]});
      const std::uint32_t side = ends[i][2];
      (side < count ? here.back().starts : here.back().ends) = side < count ? side : side - count;
    }
    std::erase_if(here,
                  [](const OpenFan& f) { return f.starts == kNoIndex || f.ends == kNoIndex; });
    for (const OpenFan& fan : here) follower[fan.starts] = fan.ends;
    if (here.size() < 2) continue;
    std::vector<std::vector<std::uint32_t>> triangles;
    for (OpenFan& fan : here) {
      triangles.push_back(triangles_of.of(fan.fan));
      for (const std::uint32_t t : triangles.back()) {
        fan.normal += doubled_area_vector(mesh, mesh.triangles[t]);
      }
    }
    const std::vector<OpenFan> around = in_order(mesh, ends[begin][0], here, sides, triangles);
    for (std::size_t i = 0; i < around.size(); ++i) {
      follower[around[(i + 1) % around.size()].starts] = around[i].ends;
    }
  }
  return follower;
}

}  // namespace

std::size_t orient_vertex_attached_fragments(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> component = triangle_components(mesh);
  const std::uint32_t count =
      component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  if (count < 2) return 0;
  std::vector<double> area(count, 0.0);
  std::vector<Vec3> normal(mesh.triangles.size());
  std::vector<std::vector<std::uint32_t>> of_component(count);
  const VertexCorners around(mesh);
  for (std::uint32_t t = 0; t < component.size(); ++t) {
    normal[t] = doubled_area_vector(mesh, mesh.triangles[t]);
    area[component[t]] += normal[t].norm();
    of_component[component[t]].push_back(t);
  }
  const auto largest =
      static_cast<std::uint32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  std::vector<bool> open(count, false), settled(count, false), waiting(count, false);
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    if (sides.size() == 1) open[component[sides[0].triangle]] = true;
  });
  std::vector<std::uint32_t> queue = {largest};
  waiting[largest] = true;
  std::size_t turned = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t here = queue[i];
    double agreement = 0.0;
    std::vector<std::uint32_t> next;
    for (const std::uint32_t t : of_component[here]) {
      for (const std::uint32_t v : mesh.triangles[t]) {
        for (const std::uint32_t corner : around.corners_of(v)) {
          const std::uint32_t there = component[corner / 3];
          if (there == here) continue;
          if (settled[there]) agreement += normal[t].dot(normal[corner / 3]);
          if (!waiting[there]) next.push_back(there);
        }
      }
    }
    settled[here] = true;
    for (const std::uint32_t there : next) {
      if (waiting[there]) continue;
      waiting[there] = true;
      queue.push_back(there);
    }
    if (agreement >= 0.0 || !open[here]) continue;
    for (const std::uint32_t t : of_component[here]) {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      normal[t] = -normal[t];
      ++turned;
    }
  }
  return turned;
}

std::vector<std::vector<std::uint32_t>> find_hole_loops(const TriangleMesh& mesh) {
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  const std::vector<std::uint32_t> fans = corner_fans(mesh, sorted);
  const std::vector<BorderSide> sides = border_sides(sorted, fans);
  const std::vector<std::uint32_t> follower = followers(mesh, sides, fans);
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<bool> used(sides.size(), false);
  for (std::uint32_t first = 0; first < sides.size(); ++first) {
    if (used[first]) continue;
    loops.emplace_back();
    std::uint32_t side = first;
    for (; side != kNoIndex && !used[side]; side = follower[side]) {
      used[side] = true;
      loops.back().push_back(sides[side].to);  // against the triangle, from `to` to `from`
    }
    if (side != first) loops.pop_back();
  }
  return loops;
}

}  // namespace clast::reconstruct_detail
