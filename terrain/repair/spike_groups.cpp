#include "terrain/repair/spike_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/disjoint_sets.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/repair/detail/ring_plane.hpp"

namespace clast::terrain_detail {
namespace {

// More vertices than that are a tower, a tree or a rock.
constexpr std::size_t kMaxGroup = 8;
constexpr double kSuspectGroup = 0.5;  // of the steepness, in a second look
constexpr double kGroupAlone = 3.0;  // times the farthest of the ground around, as for single ones
constexpr double kSamePlace = 1e-6;  // m, in plan, of vertices that nothing joins
constexpr std::size_t kFewAround = 4;  // from which one ring is enough to know the ground

/// Vertices in sets of no more than a group's, joined by those edges that `joins(a, b)` names.
template <class Joins>
std::vector<bool> in_small_sets(const TriangleMesh& mesh, const Joins& joins) {
  DisjointSets sets(mesh.vertices.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (joins(t[k], t[(k + 1) % 3])) sets.join(t[k], t[(k + 1) % 3]);
    }
  }
  std::vector<std::uint32_t> size(mesh.vertices.size(), 0);
  for (std::uint32_t v = 0; v < size.size(); ++v) ++size[sets.find(v)];
  std::vector<bool> small(mesh.vertices.size());
  for (std::uint32_t v = 0; v < size.size(); ++v) small[v] = size[sets.find(v)] <= kMaxGroup;
  return small;
}

/// Vertices that steep edges part from all but a few others.
std::vector<bool> loose_vertices(const TriangleMesh& mesh, double steepness) {
  return in_small_sets(mesh, [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 d = mesh.vertices[b] - mesh.vertices[a];
    return d.z() * d.z() <= steepness * steepness * d.head<2>().squaredNorm();
  });
}

/// The loose vertices of which no more than a group's are joined by edges: not the many on cliffs.
std::vector<bool> few_together(const TriangleMesh& mesh, const std::vector<bool>& loose) {
  std::vector<bool> few =
      in_small_sets(mesh, [&](std::uint32_t a, std::uint32_t b) { return loose[a] && loose[b]; });
  for (std::size_t v = 0; v < few.size(); ++v) few[v] = few[v] && loose[v];
  return few;
}

/// Groups of loose vertices with what is around them.
class Surroundings {
 public:
  /// @param few  the loose vertices that matter
  Surroundings(const TriangleMesh& mesh, const std::vector<bool>& loose,
               const std::vector<bool>& few, double width)
      : mesh_(mesh), loose_(loose), width_(std::max(width, kSamePlace)) {
    const TriangleNeighbours links = triangle_neighbours(mesh);
    std::vector<bool> wanted = few, border(mesh.vertices.size(), false);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const TriangleMesh::Triangle& corners = mesh.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (!links.is_border_side(t, k)) continue;
        const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
        border[a] = border[b] = true;
        sides_.push_back({a, b});
        side_boxes_.emplace_back();
        side_boxes_.back().include(mesh.vertices[a].head<2>());
        side_boxes_.back().include(mesh.vertices[b].head<2>());
      }
      if (few[corners[0]] || few[corners[1]] || few[corners[2]]) {
        for (const std::uint32_t v : corners) wanted[v] = true;
      }
    }
    side_index_.emplace(side_boxes_);
    for (std::uint32_t v = 0; v < few.size(); ++v) {
      if (!few[v] || !border[v]) continue;
      on_border_.insert(v);
      for (const std::uint32_t copy : copies_of(v)) {
        copies_[v].insert(copy);
        copies_[copy].insert(v);
        wanted[copy] = true;
      }
    }
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!wanted[t[k]]) continue;
        around_[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
      }
    }
  }

  bool on_border(std::uint32_t v) const { return on_border_.contains(v); }
  const std::set<std::uint32_t>& around(std::uint32_t v) const { return of(around_, v); }
  /// Border vertices at the same place of the plan that no edge joins to it.
  const std::set<std::uint32_t>& copies(std::uint32_t v) const { return of(copies_, v); }

  /// Height of the border that passes over or under a vertex, the nearest.
  std::optional<double> border_height(std::uint32_t vertex) const {
    const double height = mesh_.vertices[vertex].z();
    const Vec2 at = mesh_.vertices[vertex].head<2>();
    PlanBox here;
    here.include(at);
    std::optional<double> best;
    for (const std::uint32_t s : side_index_->boxes_near(here.expanded(width_))) {
      const auto [a, b] = sides_[s];
      if (a == vertex || b == vertex) continue;
      const Vec3 &from = mesh_.vertices[a], &to = mesh_.vertices[b];
      const Vec2 along = (to - from).head<2>();
      const double share =
          std::clamp((at - from.head<2>()).dot(along) / along.squaredNorm(), 0.0, 1.0);
      if (!((from.head<2>() + share * along - at).norm() <= width_)) continue;
      const double z = from.z() + share * (to.z() - from.z());
      if (!best || std::abs(z - height) < std::abs(*best - height)) best = z;
    }
    return best;
  }

 private:
  using Sets = std::map<std::uint32_t, std::set<std::uint32_t>>;

  static const std::set<std::uint32_t>& of(const Sets& sets, std::uint32_t v) {
    static const std::set<std::uint32_t> none;
    const auto found = sets.find(v);
    return found == sets.end() ? none : found->second;
  }

  std::set<std::uint32_t> copies_of(std::uint32_t v) const {
    const Vec2 at = mesh_.vertices[v].head<2>();
    PlanBox here;
    here.include(at);
    std::set<std::uint32_t> result, joined;
    for (const std::uint32_t s : side_index_->boxes_near(here.expanded(width_))) {
      const auto& [a, b] = sides_[s];
      if (a == v) joined.insert(b);
      if (b == v) joined.insert(a);
      for (const std::uint32_t end : {a, b}) {
        if (end != v && (mesh_.vertices[end].head<2>() - at).norm() <= width_) result.insert(end);
      }
    }
    for (const std::uint32_t end : joined) result.erase(end);
    return result;
  }

  const TriangleMesh& mesh_;
  const std::vector<bool>& loose_;
  double width_;
  std::vector<std::array<std::uint32_t, 2>> sides_;
  std::vector<PlanBox> side_boxes_;
  std::optional<PlanIndex> side_index_;
  std::set<std::uint32_t> on_border_;  ///< of the loose ones
  Sets around_, copies_;
};

/// Loose vertices from `seed` on that edges or a common place join.
std::vector<std::uint32_t> group_of(std::uint32_t seed, const std::vector<bool>& loose,
                                    const Surroundings& surroundings, std::vector<bool>& seen) {
  std::vector<std::uint32_t> group = {seed};
  seen[seed] = true;
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (const auto* next : {&surroundings.around(group[i]), &surroundings.copies(group[i])}) {
      for (const std::uint32_t v : *next) {
        if (!loose[v] || seen[v]) continue;
        seen[v] = true;
        group.push_back(v);
      }
    }
  }
  return group;
}

/// The sound vertices next to some others.
std::set<std::uint32_t> sound_around(const std::vector<bool>& loose,
                                     const Surroundings& surroundings, const auto& vertices) {
  std::set<std::uint32_t> result;
  for (const std::uint32_t v : vertices) {
    for (const auto* next : {&surroundings.around(v), &surroundings.copies(v)}) {
      for (const std::uint32_t other : *next) {
        if (!loose[other]) result.insert(other);
      }
    }
  }
  return result;
}

struct Levelled {
  std::size_t count = 0;
  double farthest = 0.0;  ///< m
  Vec3 at = Vec3::Zero();
};

/// True if a vertex of the group protrudes more steeply than `steepness` from its ring, and by more
/// than the ground's roughness.
/// @param off  distance of a vertex from the plane of the ground, m
template <class Off>
bool stands_out(const TriangleMesh& mesh, const std::vector<std::uint32_t>& group,
                const std::set<std::uint32_t>& ring, const Surroundings& surroundings,
                double steepness, double roughness, const Off& off) {
  return std::any_of(group.begin(), group.end(), [&](std::uint32_t v) {
    double distance = 1e300;
    for (const std::uint32_t other : ring) {
      if (surroundings.copies(v).contains(other)) continue;
      const double apart = (mesh.vertices[other] - mesh.vertices[v]).head<2>().norm();
      distance = std::min(distance, apart);
    }
    return off(v) > steepness * distance && off(v) > kGroupAlone * roughness;
  });
}

void level_group(TriangleMesh& mesh, const std::vector<std::uint32_t>& group,
                 const std::vector<bool>& loose, const Surroundings& surroundings, double steepness,
                 Levelled& levelled) {
  const bool at_border = std::any_of(group.begin(), group.end(),
                                     [&](std::uint32_t v) { return surroundings.on_border(v); });
  const std::set<std::uint32_t> ring = sound_around(loose, surroundings, group);
  std::set<std::uint32_t> wide = sound_around(loose, surroundings, ring);
  wide.insert(ring.begin(), ring.end());
  const std::set<std::uint32_t>& ground = at_border || ring.size() < kFewAround ? wide : ring;
  const std::vector<std::uint32_t> fitted(ground.begin(), ground.end());
  const Vec3 first = mesh.vertices[group.front()];
  const std::optional<NeighbourPlane> plane = fit_neighbour_plane(mesh, fitted, group.front());
  if (!plane) return;
  const auto off = [&](std::uint32_t v) {
    const Vec3& p = mesh.vertices[v];
    return std::abs(p.z() - plane->height_at((p - first).head<2>()));
  };
  double roughness = 0.0;
  for (const std::uint32_t v : wide) roughness = std::max(roughness, off(v));
  if (!stands_out(mesh, group, ring, surroundings, steepness, roughness, off)) return;
  std::vector<std::uint32_t> moved;
  for (const std::uint32_t v : group) {
    const double by = off(v);
    if (by <= kGroupAlone * roughness) continue;
    moved.push_back(v);
    ++levelled.count;
    if (by > levelled.farthest) {
      levelled.farthest = by;
      levelled.at = mesh.vertices[v];
    }
    mesh.vertices[v].z() = plane->height_at((mesh.vertices[v] - first).head<2>());
  }
  // Snaps to the other tile at a cut: first to its vertices, then to its border between them.
  for (const std::uint32_t v : moved) {
    for (const std::uint32_t copy : surroundings.copies(v)) {
      if (!loose[copy] || copy < v) mesh.vertices[v].z() = mesh.vertices[copy].z();
    }
  }
  for (const std::uint32_t v : moved) {
    if (!surroundings.on_border(v) || !surroundings.copies(v).empty()) continue;
    double& height = mesh.vertices[v].z();
    const double other = surroundings.border_height(v).value_or(height);
    if (std::abs(other - height) <= kGroupAlone * roughness) height = other;
  }
}

}  // namespace

void level_spike_groups(TriangleMesh& mesh, double steepness, double width, TerrainReport& report) {
  if (!(steepness > 0.0)) return;
  Levelled levelled;
  // A vertex that was put between a spike and the ground stands on a gentler edge than the spike.
  for (const double share : {1.0, kSuspectGroup}) {
    const std::vector<bool> loose = loose_vertices(mesh, share * steepness);
    const std::vector<bool> few = few_together(mesh, loose);
    if (std::find(few.begin(), few.end(), true) == few.end()) continue;
    const Surroundings surroundings(mesh, loose, few, width);
    std::vector<bool> seen(mesh.vertices.size(), false);
    for (std::uint32_t v = 0; v < loose.size(); ++v) {
      if (!few[v] || seen[v]) continue;
      const std::vector<std::uint32_t> group = group_of(v, loose, surroundings, seen);
      const bool alone = group.size() == 1 && !surroundings.on_border(v);
      const bool of_many =
          std::any_of(group.begin(), group.end(), [&](std::uint32_t each) { return !few[each]; });
      if (alone || of_many || group.size() > kMaxGroup) continue;
      level_group(mesh, group, loose, surroundings, steepness, levelled);
    }
  }
  report.levelled_spikes += levelled.count;
  if (levelled.count == 0) return;
  report.notes.push_back(std::to_string(levelled.count) +
                         " vertices far above or below the ground, in groups or on a border, were "
                         "moved to the plane of the surrounding ground, the farthest by " +
                         format_significant(levelled.farthest, 3) + " m, at " +
                         format_map_point(levelled.at));
}

}  // namespace clast::terrain_detail
