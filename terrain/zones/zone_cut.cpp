#include "terrain/zones/zone_cut.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/plan_index.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kNear = 1e-6;  // m

using Triangle = TriangleMesh::Triangle;

/// Signed distance of a point from the line through two others.
double offset(const Vec2& from, const Vec2& to, const Vec2& point) {
  const double length = (to - from).norm();
  return length > 0.0 ? cross(to - from, point - from) / length : (point - from).norm();
}

/// A mesh whose triangles are divided, with their neighbours and the triangles they came from.
class CutMesh {
 public:
  explicit CutMesh(TriangleMesh& mesh)
      : mesh_(mesh),
        across_(triangle_neighbours(mesh).neighbour),
        parts_(mesh.triangles.size()),
        index_(plan_boxes(mesh)) {
    for (std::uint32_t t = 0; t < parts_.size(); ++t) {
      parts_[t] = {t};
      first_.push_back(t);
    }
  }

  void insert(const Vec2& point) {
    while (const std::optional<Spot> spot = spot_to_divide(point)) {
      if (spot->side < 3) {
        divide_side(spot->triangle, spot->side, spot->share);
      } else {
        divide_inside(spot->triangle, point);
      }
    }
  }

  /// Both ends must have been inserted.
  void insert(const Vec2& from, const Vec2& to) {
    PlanBox box;
    box.include(from);
    box.include(to);
    // Dividing a side leaves parts that the segment may cross as well.
    for (bool again = true; again;) {
      again = false;
      for (const std::uint32_t t : triangles_near(box)) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::optional<double> share = crossing(t, k, from, to);
          if (!share) continue;
          divide_side(t, k, *share);
          again = true;
        }
      }
    }
  }

 private:
  Vec2 plan(std::uint32_t vertex) const { return mesh_.vertices[vertex].head<2>(); }

  std::vector<std::uint32_t> triangles_near(const PlanBox& box) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t first : index_.boxes_near(box.expanded(kNear))) {
      found.insert(found.end(), parts_[first].begin(), parts_[first].end());
    }
    return found;
  }

  /// Position along side k of a triangle at which the segment crosses it, if properly inside both.
  std::optional<double> crossing(std::uint32_t t, std::size_t k, const Vec2& from,
                                 const Vec2& to) const {
    const Vec2 a = plan(mesh_.triangles[t][k]), b = plan(mesh_.triangles[t][(k + 1) % 3]);
    const double at_a = offset(from, to, a), at_b = offset(from, to, b);
    if (!((at_a > kNear && at_b < -kNear) || (at_a < -kNear && at_b > kNear))) return {};
    const double share = at_a / (at_a - at_b);
    const Vec2 point = a + share * (b - a);
    const double along = (point - from).dot(to - from) / (to - from).norm();
    if (along < kNear || along > (to - from).norm() - kNear) return {};
    return share;
  }

  /// Position of a point in a triangle: on a side, at a fraction of it, or inside (side 3).
  struct Spot {
    std::uint32_t triangle;
    std::size_t side;
    double share;
  };

  /// The first triangle that holds the point away from its corners. Upright ones are divided
  /// through those beside them.
  std::optional<Spot> spot_to_divide(const Vec2& point) const {
    for (const std::uint32_t t : triangles_near({point, point})) {
      const Triangle& corners = mesh_.triangles[t];
      const double sign = doubled_area_vector(mesh_, mesh_.triangles[t]).z() > 0.0 ? 1.0 : -1.0;
      int inside = 0;
      std::optional<Spot> on_side;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 a = plan(corners[k]), b = plan(corners[(k + 1) % 3]);
        const double length = (b - a).norm();
        if (!(length > 2.0 * kNear)) continue;
        const double off = sign * offset(a, b, point);
        const double along = (point - a).dot(b - a) / length;
        if (off > kNear) ++inside;
        if (std::abs(off) <= kNear && along > kNear && along < length - kNear) {
          on_side = Spot{t, k, along / length};
        }
      }
      if (inside == 3) return Spot{t, 3, 0.0};
      if (on_side && inside == 2) return on_side;
    }
    return std::nullopt;
  }

  /// Splits into three, around the point on the triangle's plane.
  void divide_inside(std::uint32_t t, const Vec2& point) {
    const Triangle corners = mesh_.triangles[t];
    const Vec3 &a = mesh_.vertices[corners[0]], &b = mesh_.vertices[corners[1]],
               &c = mesh_.vertices[corners[2]];
    const Vec2 ab = (b - a).head<2>(), ac = (c - a).head<2>(), ap = point - a.head<2>();
    const double v = cross(ap, ac) / cross(ab, ac), w = cross(ab, ap) / cross(ab, ac);
    const Vec3 on_plane = a + v * (b - a) + w * (c - a);
    const auto middle = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(on_plane);
    const std::uint32_t two = add({corners[1], corners[2], middle}, t);
    const std::uint32_t three = add({corners[2], corners[0], middle}, t);
    mesh_.triangles[t] = {corners[0], corners[1], middle};
    const std::array<std::uint32_t, 3> around = across_[t];
    across_[t] = {around[0], two, three};
    across_[two] = {around[1], three, t};
    across_[three] = {around[2], t, two};
    relink(around[1], t, two);
    relink(around[2], t, three);
  }

  /// Divides a side, and with it the triangles on both sides of it.
  void divide_side(std::uint32_t t, std::size_t k, double share) {
    const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
    const std::uint32_t other = across_[t][k];
    const auto middle = static_cast<std::uint32_t>(mesh_.vertices.size());
    const Vec3 point = mesh_.vertices[a] + share * (mesh_.vertices[b] - mesh_.vertices[a]);
    mesh_.vertices.push_back(point);
    const std::uint32_t far = bisect(t, k, middle);
    if (other == kNoIndex) return;
    const std::size_t side = find_edge_side(mesh_.triangles[other], a, b);
    const std::uint32_t other_far = bisect(other, side, middle);
    // `t` keeps a, `far` has b; on the other side the first corner of the side stays.
    const bool against = mesh_.triangles[other][side] == b;
    const std::uint32_t with_a = against ? other_far : other;
    const std::uint32_t with_b = against ? other : other_far;
    link(t, with_a, a, middle);
    link(far, with_b, b, middle);
  }

  /// Splits a triangle from a point on side k to the opposite corner. Returns the part at the end.
  std::uint32_t bisect(std::uint32_t t, std::size_t k, std::uint32_t middle) {
    const Triangle corners = mesh_.triangles[t];
    const std::uint32_t b = corners[(k + 1) % 3], apex = corners[(k + 2) % 3];
    const std::uint32_t beyond = across_[t][(k + 1) % 3];
    const std::uint32_t part = add({middle, b, apex}, t);
    mesh_.triangles[t][(k + 1) % 3] = middle;
    across_[part] = {kNoIndex, beyond, t};
    across_[t][(k + 1) % 3] = part;
    across_[t][k] = kNoIndex;
    relink(beyond, t, part);
    return part;
  }

  std::uint32_t add(const Triangle& corners, std::uint32_t from) {
    const auto number = static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.triangles.push_back(corners);
    across_.push_back({kNoIndex, kNoIndex, kNoIndex});
    first_.push_back(first_[from]);
    parts_[first_[from]].push_back(number);
    return number;
  }

  void relink(std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    if (t == kNoIndex) return;
    for (std::uint32_t& side : across_[t]) {
      if (side == from) {
        side = to;
        return;
      }
    }
  }

  void link(std::uint32_t one, std::uint32_t two, std::uint32_t a, std::uint32_t b) {
    across_[one][find_edge_side(mesh_.triangles[one], a, b)] = two;
    across_[two][find_edge_side(mesh_.triangles[two], a, b)] = one;
  }

  TriangleMesh& mesh_;
  std::vector<std::array<std::uint32_t, 3>> across_;
  std::vector<std::vector<std::uint32_t>> parts_;  ///< of every triangle there was
  std::vector<std::uint32_t> first_;               ///< of every triangle, the one it came from
  PlanIndex index_;
};

}  // namespace

std::size_t insert_edges_along_segments(TriangleMesh& mesh,
                                        std::span<const std::array<Vec2, 2>> segments) {
  const std::size_t before = mesh.triangles.size();
  CutMesh cut(mesh);
  for (const auto& [from, to] : segments) {
    cut.insert(from);
    cut.insert(to);
  }
  for (const auto& [from, to] : segments) {
    if ((to - from).norm() > 2.0 * kNear) cut.insert(from, to);
  }
  return mesh.triangles.size() - before;
}

}  // namespace clast::terrain_detail
