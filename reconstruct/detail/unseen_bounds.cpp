#include "reconstruct/detail/unseen_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/mesh_topology.hpp"
#include "reconstruct/detail/box_ranges.hpp"
#include "reconstruct/detail/enclosed_space.hpp"
#include "reconstruct/detail/flank_planes.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Largest upper volume against that of what is closed: a quarter of the block may be unseen
/// where the flanks alone bound it, half of it where a floor does. Beyond, planes of the flanks
/// meet so far from what was seen that a small error of theirs moves the bound by tenths of the
/// volume, and a part that no flank announces becomes likely.
constexpr double kMostByFlanks = 4.0 / 3.0, kMostOnFloor = 2.0;
constexpr double kLeastLeftByDent = 0.5;  ///< of the volume, by a closure that is dented
/// The planes are moved out by so many slacks where sides are bounded: a corner that stands out is
/// seen in them and hardly in the volume.
constexpr double kSideSlacks = 1.5;
/// The slack holds for closures that are as wide as this share of the root of the body's area.
constexpr double kSlackWidth = 0.1;
/// What a small closure hides is no longer than so many of its widths, also where no flank ends it.
constexpr double kLongestHidden = 3.0;
/// Distance of what is behind a closure, against that of the closure, from the middle.
constexpr double kFarthestBehind = 10.0;
constexpr double kSmallClosure = 0.2;  ///< width against the root of the body's area
constexpr double kBefore = 1.0;        ///< a closure is looked through from so many of its widths

struct Middle {
  Vec3 place = Vec3::Zero();
  double volume = 0.0;
};

Middle middle_of(const TriangleMesh& closed) {
  const Vec3 origin = closed.vertices[0];
  Middle middle;
  for (const auto& [a, b, c] : closed.triangles) {
    const Vec3 p = closed.vertices[a] - origin, q = closed.vertices[b] - origin,
               r = closed.vertices[c] - origin;
    const double tetrahedron = p.dot(q.cross(r)) / 6.0;
    middle.volume += tetrahedron;
    middle.place += tetrahedron * (p + q + r) / 4.0;
  }
  middle.place = origin + middle.place / middle.volume;
  return middle;
}

/// The same surface with the closures behind what was seen.
struct Parted {
  TriangleMesh closed;
  std::size_t first = 0;            ///< triangles from this one on are closures
  std::vector<std::uint32_t> rims;  ///< vertices of closures and of what was seen
};

Parted parted(const TriangleMesh& closed, const std::vector<bool>& closure) {
  Parted parts{{closed.vertices, {}}, 0, {}};
  std::vector<bool> seen(closed.vertices.size(), false), on_rim(closed.vertices.size(), false);
  for (std::size_t t = 0; t < closure.size(); ++t) {
    if (closure[t]) continue;
    parts.closed.triangles.push_back(closed.triangles[t]);
    for (const std::uint32_t v : closed.triangles[t]) seen[v] = true;
  }
  parts.first = parts.closed.triangles.size();
  for (std::size_t t = 0; t < closure.size(); ++t) {
    if (!closure[t]) continue;
    parts.closed.triangles.push_back(closed.triangles[t]);
    for (const std::uint32_t v : closed.triangles[t]) {
      if (!seen[v] || on_rim[v]) continue;
      on_rim[v] = true;
      parts.rims.push_back(v);
    }
  }
  return parts;
}

/// One connected closure.
struct Closure {
  std::vector<Corners> triangles;
  Vec3 vector_area = Vec3::Zero(), centre = Vec3::Zero();
  double area = 0.0;

  double width() const { return std::sqrt(area); }
  bool faces() const { return vector_area.norm() > 0.0; }  ///< has a way that it faces
};

std::vector<Closure> collect_closures(const Parted& parts) {
  TriangleMesh all{parts.closed.vertices, {}};
  all.triangles.assign(parts.closed.triangles.begin() + static_cast<std::ptrdiff_t>(parts.first),
                       parts.closed.triangles.end());
  const std::vector<std::uint32_t> closure_of = triangle_components(all);
  std::vector<Closure> closures;
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    if (closure_of[t] >= closures.size()) closures.resize(closure_of[t] + 1);
    Closure& closure = closures[closure_of[t]];
    const auto& [a, b, c] = all.triangles[t];
    const Vec3 &p = all.vertices[a], &q = all.vertices[b], &r = all.vertices[c];
    const Vec3 area = 0.5 * (q - p).cross(r - p);
    closure.triangles.push_back({p, q, r});
    closure.vector_area += area;
    closure.area += area.norm();
    closure.centre += area.norm() * (p + q + r) / 3.0;
  }
  for (Closure& closure : closures) {
    if (closure.area > 0.0) closure.centre /= closure.area;
  }
  return closures;
}

/// What may lie behind all closures together.
class Behind {
 public:
  Behind(const std::vector<Closure>& closures, const FlankPlanes& flanks,
         const std::optional<Plane>& floor, const Middle& middle, double size)
      : closures_(closures), flanks_(flanks), floor_(floor), middle_(middle), size_(size) {}

  /// What a closure may be dented by, or stand out over the planes of the flanks: roughness grows
  /// with the width over which it is looked at, and was measured over patches.
  double slack(const Closure& closure) const {
    return flanks_.slack * std::min(1.0, closure.width() / (kSlackWidth * size_));
  }

  /// What closures of no area hide is nothing.
  /// @param slacks  by which the planes lie outside of what was seen
  /// @returns for each closure; none where one of them is not bounded
  std::optional<std::vector<EnclosedSpace>> within(double slacks) const {
    std::vector<EnclosedSpace> spaces(closures_.size());
    for (std::size_t i = 0; i < closures_.size(); ++i) {
      const Closure& closure = closures_[i];
      if (!(closure.area > 0.0)) continue;
      const std::vector<Plane> planes = planes_behind(closure, slacks);
      const double farthest = kFarthestBehind * (closure.centre - middle_.place).norm();
      auto space =
          enclosed_space(closure.triangles, place_before(closure, planes), planes, farthest);
      if (!space) return std::nullopt;
      spaces[i] = std::move(*space);
    }
    return spaces;
  }

 private:
  std::vector<Plane> planes_behind(const Closure& closure, double slacks) const {
    std::vector<Plane> planes = flanks_.planes;
    for (Plane& plane : planes) plane.distance += slacks * slack(closure) - flanks_.slack;
    if (floor_) planes.push_back({-floor_->normal, -floor_->distance});
    if (closure.width() < kSmallClosure * size_ && closure.faces()) {
      const Vec3 out = closure.vector_area.normalized();
      planes.push_back({out, out.dot(closure.centre) + kLongestHidden * closure.width()});
    }
    return planes;
  }

  /// From close before a closure more of what lies beyond its rim is seen through it: of a concave
  /// body that may widen behind the closure.
  Vec3 place_before(const Closure& closure, const std::vector<Plane>& planes) const {
    if (!closure.faces()) return middle_.place;
    const Vec3 place =
        closure.centre - kBefore * closure.width() * closure.vector_area.normalized();
    const bool within = std::all_of(planes.begin(), planes.end(),
                                    [&](const Plane& plane) { return plane.height(place) < 0.0; });
    return within ? place : middle_.place;
  }

  const std::vector<Closure>& closures_;
  const FlankPlanes& flanks_;
  const std::optional<Plane>& floor_;
  const Middle& middle_;
  double size_;
};

/// Where the flanks around a small closure draw together, a tip may stand behind it that is more
/// slender than they announce: up to twice as far out as their planes meet, by no more than the
/// closure is wide, and the less the larger the closure is.
/// @param space  behind the closure
/// @param slack  of the planes that its places lie on, m
/// @param size   root of the area of the body, m
void add_tip(EnclosedSpace& space, const Closure& closure, double slack, double size) {
  const double width = closure.width(), share = width / (kSmallClosure * size);
  if (!closure.faces() || share >= 1.0) return;
  const Vec3 out = closure.vector_area.normalized();
  double reach = 0.0;
  for (const Vec3& place : space.places) reach = std::max(reach, out.dot(place - closure.centre));
  const double further = std::clamp(reach - slack, 0.0, width) * (1.0 - share);
  if (further > 0.0) space.places.push_back(closure.centre + (reach + further) * out);
}

double sum_of_volumes(const std::vector<EnclosedSpace>& spaces) {
  double volume = 0.0;
  for (const EnclosedSpace& space : spaces) volume += space.volume;
  return volume;
}

std::vector<Vec3> seen_points(const Parted& parts) {
  std::vector<Vec3> seen;
  for (std::size_t t = 0; t < parts.first; ++t) {
    for (const std::uint32_t v : parts.closed.triangles[t]) {
      seen.push_back(parts.closed.vertices[v]);
    }
  }
  return seen;
}

}  // namespace

UnseenBounds unseen_bounds(const TriangleMesh& closed, const UnseenParts& parts) {
  const Parted surface = parted(closed, parts.closure);
  const Middle middle = middle_of(closed);
  UnseenBounds bounds{middle.volume, middle.volume, middle.volume, {}};
  std::vector<Vec3> beyond;
  if (surface.first < closed.triangles.size()) {
    const FlankPlanes flanks = flank_planes(surface.closed, surface.first, surface.rims);
    const std::vector<Closure> closures = collect_closures(surface);
    const double size = std::sqrt(surface_area(closed));
    const Behind behind(closures, flanks, parts.floor, middle, size);
    for (const Closure& closure : closures) {
      bounds.lower_volume -= behind.slack(closure) * closure.area;
    }
    const auto spaces = behind.within(1.0);
    auto wider = behind.within(kSideSlacks);
    const double most = parts.floor ? kMostOnFloor : kMostByFlanks;
    const double added = spaces ? sum_of_volumes(*spaces) : 0.0;
    if (spaces && wider && middle.volume + added <= most * middle.volume) {
      *bounds.upper_volume += added;
      for (std::size_t i = 0; i < closures.size(); ++i) {
        add_tip((*wider)[i], closures[i], kSideSlacks * behind.slack(closures[i]), size);
        beyond.insert(beyond.end(), (*wider)[i].places.begin(), (*wider)[i].places.end());
      }
    } else {
      bounds.upper_volume.reset();
    }
  }
  if (parts.margin != nullptr) {
    bounds.lower_volume -= parts.margin->volume_below;
    if (bounds.upper_volume) *bounds.upper_volume += parts.margin->volume_above;
  }
  bounds.lower_volume = std::max(bounds.lower_volume, kLeastLeftByDent * middle.volume);
  if (!bounds.upper_volume) return bounds;
  const std::vector<Vec3> seen =
      parts.margin != nullptr ? parts.margin->inner : seen_points(surface);
  std::vector<Vec3> possible = parts.margin != nullptr ? parts.margin->outer : seen;
  possible.insert(possible.end(), beyond.begin(), beyond.end());
  bounds.sides = box_ranges(seen, possible);
  if (parts.margin != nullptr) {
    const Vec3 both_ends = Vec3::Constant(2.0 * parts.margin->extremes);
    bounds.sides->lower = (bounds.sides->lower - both_ends).cwiseMax(0.0);
    bounds.sides->upper += both_ends;
  }
  return bounds;
}

}  // namespace clast::reconstruct_detail
