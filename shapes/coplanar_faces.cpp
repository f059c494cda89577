#include "shapes/coplanar_faces.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "mesh/half_edges.hpp"
#include "mesh/polygon.hpp"

namespace clast {

namespace {

using Index = std::uint32_t;
using Face = SpheroPolyhedron::Face;

constexpr Index kNone = 0xffffffffu;

/// Joins faces region by region, each from its largest face outwards.
class Merger {
 public:
  Merger(const SpheroPolyhedron& shape, double flatness) : shape_(shape) {
    Bounds box;
    for (const Vec3& vertex : shape.vertices) box.include(vertex);
    diagonal_ = box.diagonal();
    reach_ = flatness * diagonal_;
  }

  SpheroPolyhedron merged() {
    find_neighbours();
    grow_regions();
    kept_apart_.assign(regions_.size(), false);
    do {
      polygons_.clear();
      region_of_polygon_.clear();
      for (Index region = 0; region < regions_.size(); ++region) add_polygons(region);
      drop_straight_corners();
    } while (keep_uncuttable_apart());
    return renumbered();
  }

 private:
  void find_neighbours() {
    for (const Face& face : shape_.faces) neighbours_.emplace_back(face.size(), kNone);
    const std::vector<HalfEdge> sides = sorted_half_edges(shape_.faces);
    for_each_edge(sides, [&](std::span<const HalfEdge> shared) {
      if (!is_interior_edge(shared)) return;
      neighbours_[shared[0].triangle][shared[0].side] = shared[1].triangle;
      neighbours_[shared[1].triangle][shared[1].side] = shared[0].triangle;
    });
  }

  void grow_regions() {
    std::vector<Vec3> areas;
    for (const Face& face : shape_.faces) areas.push_back(doubled_face_area_vector(shape_, face));
    std::vector<Index> by_size(shape_.faces.size());
    std::iota(by_size.begin(), by_size.end(), 0u);
    std::stable_sort(by_size.begin(), by_size.end(), [&](Index a, Index b) {
      return areas[a].squaredNorm() > areas[b].squaredNorm();
    });
    region_of_.assign(shape_.faces.size(), kNone);
    for (const Index seed : by_size) {
      if (region_of_[seed] != kNone) continue;
      const Vec3 normal = areas[seed].normalized();
      const Vec3& origin = shape_.vertices[shape_.faces[seed][0]];
      const auto lies_flat = [&](Index f) {
        return areas[f].dot(normal) >= -reach_ * diagonal_ &&  // slivers may face anywhere
               std::all_of(shape_.faces[f].begin(), shape_.faces[f].end(), [&](Index v) {
                 return std::abs(normal.dot(shape_.vertices[v] - origin)) <= reach_;
               });
      };
      const auto name = static_cast<Index>(regions_.size());
      std::vector<Index> region = {seed};
      region_of_[seed] = name;
      for (std::size_t i = 0; i < region.size(); ++i) {
        for (const Index next : neighbours_[region[i]]) {
          if (next == kNone || region_of_[next] != kNone || !lies_flat(next)) continue;
          region_of_[next] = name;
          region.push_back(next);
        }
      }
      regions_.push_back(std::move(region));
    }
  }

  void add_polygons(Index region) {
    const bool alone = regions_[region].size() == 1;
    const Face outline = alone || kept_apart_[region] ? Face() : outline_of(regions_[region]);
    if (!outline.empty()) {
      polygons_.push_back(outline);
    } else {
      for (const Index f : regions_[region]) polygons_.push_back(shape_.faces[f]);
    }
    region_of_polygon_.resize(polygons_.size(), region);
  }

  /// Can all polygons be cut into triangles that face the same way? Marks regions of those that
  /// can't, and says whether there are new ones.
  bool keep_uncuttable_apart() {
    bool found = false;
    TriangleMesh cut{shape_.vertices, {}};
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      const Index region = region_of_polygon_[p];
      if (polygons_[p].size() < 4 || kept_apart_[region]) continue;
      cut.triangles.clear();
      const std::vector<std::int64_t> corners(polygons_[p].begin(), polygons_[p].end());
      bool sound = corners.size() <= kMaxEarClippingVertices;
      if (sound) append_polygon(cut, corners);
      const Vec3 normal = face_normal(shape_, polygons_[p]);
      for (const auto& [a, b, c] : cut.triangles) {
        const Vec3 ab = shape_.vertices[b] - shape_.vertices[a];
        const Vec3 ac = shape_.vertices[c] - shape_.vertices[a];
        const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
        sound = sound && ab.cross(ac).dot(normal) > 2.0 * reach_ * longest;
      }
      if (sound) continue;
      kept_apart_[region] = true;
      found = true;
    }
    return found;
  }

  /// The one loop around the region; empty when there are several or it touches itself.
  Face outline_of(const std::vector<Index>& region) const {
    std::vector<std::array<Index, 2>> border;
    for (const Index f : region) {
      const Face& face = shape_.faces[f];
      for (std::size_t k = 0; k < face.size(); ++k) {
        const Index other = neighbours_[f][k];
        if (other != kNone && region_of_[other] == region_of_[f]) continue;
        border.push_back({face[k], face[(k + 1) % face.size()]});
      }
    }
    std::sort(border.begin(), border.end());
    const bool touches = std::adjacent_find(border.begin(), border.end(), [](auto& a, auto& b) {
                           return a[0] == b[0];
                         }) != border.end();
    if (touches || border.size() < 3) return {};
    Face loop;
    Index at = border[0][0];
    do {
      loop.push_back(at);
      const auto side = std::lower_bound(border.begin(), border.end(), std::array<Index, 2>{at, 0});
      if (side == border.end() || (*side)[0] != at) return {};
      at = (*side)[1];
    } while (at != loop[0] && loop.size() <= border.size());
    return loop.size() == border.size() ? loop : Face();
  }

  bool is_straight(Index before, Index here, Index after) const {
    const Vec3 &a = shape_.vertices[before], &b = shape_.vertices[here],
               &c = shape_.vertices[after];
    const Vec3 along = c - a;
    const double length = along.norm();
    return (b - a).dot(along) > 0.0 && (c - b).dot(along) > 0.0 &&
           (b - a).cross(along).norm() <= reach_ * length;
  }

  /// A vertex of two polygons only, straight in both, is no corner of the body.
  void drop_straight_corners() {
    std::vector<std::vector<Index>> users(shape_.vertices.size());
    for (Index p = 0; p < polygons_.size(); ++p) {
      for (const Index v : polygons_[p]) users[v].push_back(p);
    }
    const auto corner_of = [&](Index p, Index v) {
      const Face& polygon = polygons_[p];
      return static_cast<std::size_t>(std::find(polygon.begin(), polygon.end(), v) -
                                      polygon.begin());
    };
    const auto straight_in = [&](Index p, Index v) {
      const Face& polygon = polygons_[p];
      const std::size_t n = polygon.size(), k = corner_of(p, v);
      return n > 3 && !kept_apart_[region_of_polygon_[p]] &&
             is_straight(polygon[(k + n - 1) % n], v, polygon[(k + 1) % n]);
    };
    for (Index v = 0; v < users.size(); ++v) {
      const std::vector<Index>& of = users[v];
      if (of.size() != 2 || of[0] == of[1] || !straight_in(of[0], v) || !straight_in(of[1], v)) {
        continue;
      }
      for (const Index p : of) {
        polygons_[p].erase(polygons_[p].begin() + static_cast<std::ptrdiff_t>(corner_of(p, v)));
      }
    }
  }

  /// Turned to start at the convex corner whose sides span most.
  void start_at_clear_corner(Face& polygon) const {
    const Vec3 normal = face_normal(shape_, polygon);
    const std::size_t n = polygon.size();
    std::size_t best = 0;
    double best_span = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3& here = shape_.vertices[polygon[k]];
      const double span = normal.dot((shape_.vertices[polygon[(k + 1) % n]] - here)
                                         .cross(shape_.vertices[polygon[(k + n - 1) % n]] - here));
      if (span > best_span) {
        best_span = span;
        best = k;
      }
    }
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(best),
                polygon.end());
  }

  SpheroPolyhedron renumbered() {
    SpheroPolyhedron result;
    result.radius = shape_.radius;
    std::vector<Index> number(shape_.vertices.size(), kNone);
    for (const Face& polygon : polygons_) {
      for (const Index v : polygon) number[v] = 0;
    }
    for (Index v = 0; v < number.size(); ++v) {
      if (number[v] == kNone) continue;
      number[v] = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(shape_.vertices[v]);
    }
    for (Face& polygon : polygons_) {
      if (polygon.size() > 3) start_at_clear_corner(polygon);
      for (Index& v : polygon) v = number[v];
    }
    result.faces = std::move(polygons_);
    result.edges = face_edges(result.faces);
    return result;
  }

  const SpheroPolyhedron& shape_;
  double diagonal_ = 0.0, reach_ = 0.0;
  std::vector<std::vector<Index>> neighbours_;  ///< face over each side, or none
  std::vector<std::vector<Index>> regions_;
  std::vector<Index> region_of_;
  std::vector<bool> kept_apart_;  ///< regions whose faces stay single
  std::vector<Face> polygons_;
  std::vector<Index> region_of_polygon_;
};

}  // namespace

SpheroPolyhedron merge_coplanar_faces(const SpheroPolyhedron& shape, double flatness) {
  if (shape.faces.empty()) return shape;
  return Merger(shape, flatness).merged();
}

}  // namespace clast
