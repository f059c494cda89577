#include "reconstruct/underside/detail/unobserved_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/underside/detail/box_ranges.hpp"
#include "reconstruct/underside/detail/enclosed_space.hpp"
#include "reconstruct/underside/detail/flank_planes.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Largest upper volume against that of what is closed: a quarter of the block may be unseen, and
/// half of it on the side of the ground, where nobody can look. Beyond, planes of the flanks
/// meet so far from what was seen that a small error of theirs moves the bound by tenths of the
/// volume, and a part that no flank announces becomes likely.
constexpr double kMaxByFlanks = 4.0 / 3.0, kMaxOnGround = 2.0;
constexpr double kMinLeftByIndentation = 0.5;  ///< of the volume, by a closure that is dented
/// The planes are moved out by so many slacks where sides are bounded: a corner that stands out is
/// seen in them and hardly in the volume.
constexpr double kSideSlacks = 1.5;
/// The slack holds for closures that are as wide as this share of the root of the body's area.
constexpr double kSlackWidth = 0.1;
/// Maximum length hidden by a small closure, in its widths, also if no flank ends it.
constexpr double kMaxHidden = 3.0;
/// Distance of what is behind a closure, against that of the closure, from the middle.
constexpr double kFarthestBehind = 10.0;
constexpr double kSmallClosure = 0.2;  ///< width against the root of the body's area
/// Mean sine of the surface's turn at a rim. An inward turn is the wall of a pit, not a gap in a
/// face. Closures that face each other through the body may be mouths of a tunnel unless their rims
/// turn outward, as those of gaps in a convex surface do.
constexpr double kTurnsInward = 0.3, kTurnsOutward = 0.05;
constexpr double kMinMouth = 0.002;         ///< of the area of the surface
constexpr double kMinLeftByHollows = 0.01;  ///< of the volume
constexpr double kBefore = 1.0;  ///< where rays through a closure begin: before it, in its widths

struct Middle {
  Vec3 position = Vec3::Zero();
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
    middle.position += tetrahedron * (p + q + r) / 4.0;
  }
  middle.position = origin + middle.position / middle.volume;
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
  std::vector<bool> observed(closed.vertices.size(), false), on_rim(closed.vertices.size(), false);
  for (std::size_t t = 0; t < closure.size(); ++t) {
    if (closure[t]) continue;
    parts.closed.triangles.push_back(closed.triangles[t]);
    for (const std::uint32_t v : closed.triangles[t]) observed[v] = true;
  }
  parts.first = parts.closed.triangles.size();
  for (std::size_t t = 0; t < closure.size(); ++t) {
    if (!closure[t]) continue;
    parts.closed.triangles.push_back(closed.triangles[t]);
    for (const std::uint32_t v : closed.triangles[t]) {
      if (!observed[v] || on_rim[v]) continue;
      on_rim[v] = true;
      parts.rims.push_back(v);
    }
  }
  return parts;
}

struct Closure {
  std::vector<TriangleCorners> triangles;
  Vec3 vector_area = Vec3::Zero(), centre = Vec3::Zero();
  double area = 0.0;

  double width() const { return std::sqrt(area); }
  bool faces() const { return vector_area.norm() > 0.0; }  ///< has a way that it faces
};

TriangleMesh closures_alone(const Parted& parts) {
  TriangleMesh all{parts.closed.vertices, {}};
  all.triangles.assign(parts.closed.triangles.begin() + static_cast<std::ptrdiff_t>(parts.first),
                       parts.closed.triangles.end());
  return all;
}

/// @param closure_of  number of the closure of each triangle of `all`
std::vector<Closure> collect_closures(const TriangleMesh& all,
                                      const std::vector<std::uint32_t>& closure_of) {
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

/// Space that may lie behind all closures.
class Behind {
 public:
  Behind(const std::vector<Closure>& closures, const FlankPlanes& flanks,
         const std::optional<Plane>& floor, const Middle& middle, double size)
      : closures_(closures), flanks_(flanks), floor_(floor), middle_(middle), size_(size) {}

  /// Depth by which a closure may be indented, or protrude over the planes of the flanks. Roughness
  /// grows with the width considered; it was measured over patches.
  double slack(const Closure& closure) const {
    return flanks_.outward_offset * std::min(1.0, closure.width() / (kSlackWidth * size_));
  }

  /// Closures without area hide nothing.
  /// @param slacks  by which the planes lie outside of what was seen
  /// @returns for each closure; none where one of them is not bounded
  std::optional<std::vector<EnclosedSpace>> within(double slacks) const {
    std::vector<EnclosedSpace> spaces(closures_.size());
    for (std::size_t i = 0; i < closures_.size(); ++i) {
      const Closure& closure = closures_[i];
      if (!(closure.area > 0.0)) continue;
      const std::vector<Plane> planes = planes_behind(closure, slacks);
      const double farthest = kFarthestBehind * (closure.centre - middle_.position).norm();
      auto space = compute_enclosed_space(closure.triangles, place_before(closure, planes), planes,
                                          farthest);
      if (!space) return std::nullopt;
      spaces[i] = std::move(*space);
    }
    return spaces;
  }

 private:
  std::vector<Plane> planes_behind(const Closure& closure, double slacks) const {
    std::vector<Plane> planes = flanks_.planes;
    for (Plane& plane : planes) plane.distance += slacks * slack(closure) - flanks_.outward_offset;
    if (floor_) planes.push_back({-floor_->normal, -floor_->distance});
    if (closure.width() < kSmallClosure * size_ && closure.faces()) {
      const Vec3 out = closure.vector_area.normalized();
      planes.push_back({out, out.dot(closure.centre) + kMaxHidden * closure.width()});
    }
    return planes;
  }

  /// Start of rays close before a closure, from where more of the space behind its rim is visible.
  /// This space may widen in a concave body.
  Vec3 place_before(const Closure& closure, const std::vector<Plane>& planes) const {
    if (!closure.faces()) return middle_.position;
    const Vec3 position =
        closure.centre - kBefore * closure.width() * closure.vector_area.normalized();
    const bool within = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return plane.signed_distance(position) < 0.0;
    });
    return within ? position : middle_.position;
  }

  const std::vector<Closure>& closures_;
  const FlankPlanes& flanks_;
  const std::optional<Plane>& floor_;
  const Middle& middle_;
  double size_;
};

/// Adds a tip behind a small closure whose flanks converge. It may be up to twice as far out as
/// their planes meet, at most the closure's width, and less for larger closures.
/// @param space  behind the closure
/// @param slack  of the planes that its places lie on, m
/// @param size   root of the area of the body, m
void add_tip(EnclosedSpace& space, const Closure& closure, double slack, double size) {
  const double width = closure.width(), fraction = width / (kSmallClosure * size);
  if (!closure.faces() || fraction >= 1.0) return;
  const Vec3 out = closure.vector_area.normalized();
  double reach = 0.0;
  for (const Vec3& position : space.points)
    reach = std::max(reach, out.dot(position - closure.centre));
  const double further = std::clamp(reach - slack, 0.0, width) * (1.0 - fraction);
  if (further > 0.0) space.points.push_back(closure.centre + (reach + further) * out);
}

/// Mean, over the rim of each closure, of the sine by which the seen surface turns outward across
/// it: below zero where it goes on into the body. Zero for a closure without a rim.
std::vector<double> outward_turns(const Parted& parts, const std::vector<Closure>& closures,
                                  const std::vector<std::uint32_t>& closure_of) {
  std::vector<double> turns(closures.size(), 0.0), lengths(closures.size(), 0.0);
  const std::vector<HalfEdge> sides = sorted_half_edges(parts.closed);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const HalfEdge &one = sides[i], &other = sides[i + 1];
    if (!one.is_same_edge(other)) continue;
    const bool first_seen = one.triangle < parts.first;
    if (first_seen == (other.triangle < parts.first)) continue;
    const std::uint32_t which =
        closure_of[(first_seen ? other.triangle : one.triangle) - parts.first];
    const Closure& closure = closures[which];
    if (!closure.faces()) continue;
    const std::uint32_t corner = (first_seen ? one : other).opposite_corner();
    const Vec3& apex = parts.closed.vertices[parts.closed.triangles[corner / 3][corner % 3]];
    const Vec3 &a = parts.closed.vertices[one.low], &b = parts.closed.vertices[one.high];
    const Vec3 along = (b - a).normalized(), to_rim = a - apex;
    const Vec3 across = (to_rim - to_rim.dot(along) * along).normalized();
    if (!across.allFinite()) continue;
    const double length = (b - a).norm();
    turns[which] += length * across.dot(closure.vector_area.normalized());
    lengths[which] += length;
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (lengths[i] > 0.0) turns[i] /= lengths[i];
  }
  return turns;
}

/// Space straight behind a mouth: its volume, and the closure at which most of it ends.
struct Column {
  double volume = 0.0;
  std::optional<std::uint32_t> ends_at;
};

Column column_behind(const Parted& parts, const TriangleTree& tree, const Closure& closure,
                     const std::vector<std::uint32_t>& closure_of, std::uint32_t closure_index) {
  const Vec3 out = closure.vector_area.normalized();
  Column column;
  std::map<std::uint32_t, double> facing_area;
  for (std::size_t t = 0; t < closure_of.size(); ++t) {
    if (closure_of[t] != closure_index) continue;
    const auto triangle = static_cast<std::uint32_t>(parts.first + t);
    const Vec3 area = doubled_area_vector(parts.closed, parts.closed.triangles[triangle]);
    const double facing = 0.5 * area.dot(out);
    if (!(facing > 0.0)) continue;
    const auto& [a, b, c] = parts.closed.triangles[triangle];
    const std::vector<Vec3>& at = parts.closed.vertices;
    const auto hit = tree.first_exit((at[a] + at[b] + at[c]) / 3.0, -out, triangle);
    if (!hit) continue;
    column.volume += facing * hit->distance;
    if (hit->triangle >= parts.first)
      facing_area[closure_of[hit->triangle - parts.first]] += facing;
  }
  for (const auto& [other, facing] : facing_area) {
    if (other != closure_index && 2.0 * facing > closure.vector_area.norm()) column.ends_at = other;
  }
  return column;
}

/// Cavities and tunnels that may be behind the closures; a tunnel is listed once.
std::vector<PossibleHollow> possible_hollows(const Parted& parts,
                                             const std::vector<Closure>& closures,
                                             const std::vector<std::uint32_t>& closure_of) {
  const std::vector<double> turns = outward_turns(parts, closures, closure_of);
  std::vector<std::uint32_t> mouths;
  const double least = kMinMouth * surface_area(parts.closed);
  for (std::uint32_t i = 0; i < closures.size(); ++i) {
    if (turns[i] < kTurnsOutward && closures[i].faces() && closures[i].area > least) {
      mouths.push_back(i);
    }
  }
  std::vector<PossibleHollow> hollows;
  if (mouths.empty()) return hollows;
  const TriangleTree tree(parts.closed);
  std::map<std::uint32_t, Column> columns;
  for (const std::uint32_t i : mouths) {
    columns[i] = column_behind(parts, tree, closures[i], closure_of, i);
  }
  for (const std::uint32_t i : mouths) {
    const Column& column = columns[i];
    PossibleHollow hollow{closures[i].centre, closures[i].width(), column.volume, {}};
    if (column.ends_at && columns.contains(*column.ends_at)) {
      const Column& other = columns[*column.ends_at];
      if (other.ends_at == i && *column.ends_at < i) continue;  // listed from the other end
      hollow.other_opening = closures[*column.ends_at].centre;
      hollow.volume = std::max(hollow.volume, other.volume);
    } else if (turns[i] > -kTurnsInward) {
      continue;
    }
    hollows.push_back(hollow);
  }
  return hollows;
}

double sum_of_volumes(const std::vector<EnclosedSpace>& spaces) {
  double volume = 0.0;
  for (const EnclosedSpace& space : spaces) volume += space.volume;
  return volume;
}

std::vector<Vec3> observed_points(const Parted& parts) {
  std::vector<Vec3> observed;
  for (std::size_t t = 0; t < parts.first; ++t) {
    for (const std::uint32_t v : parts.closed.triangles[t]) {
      observed.push_back(parts.closed.vertices[v]);
    }
  }
  return observed;
}

}  // namespace

UnobservedPartBounds bound_unobserved_parts(const TriangleMesh& closed,
                                            const UnobservedParts& parts) {
  const Parted surface = parted(closed, parts.is_closure);
  const Middle middle = middle_of(closed);
  UnobservedPartBounds bounds{{middle.volume, middle.volume, middle.volume}, {}};
  std::vector<Vec3> beyond;
  if (surface.first < closed.triangles.size()) {
    const FlankPlanes flanks = fit_flank_planes(surface.closed, surface.first, surface.rims);
    const TriangleMesh all = closures_alone(surface);
    const std::vector<std::uint32_t> closure_of = triangle_components(all);
    const std::vector<Closure> closures = collect_closures(all, closure_of);
    const double size = std::sqrt(surface_area(closed));
    const Behind behind(closures, flanks, parts.floor, middle, size);
    for (const Closure& closure : closures) {
      bounds.lower_volume -= behind.slack(closure) * closure.area;
    }
    const auto spaces = behind.within(1.0);
    auto wider = behind.within(kSideSlacks);
    const double most = parts.on_ground ? kMaxOnGround : kMaxByFlanks;
    const double added = spaces ? sum_of_volumes(*spaces) : 0.0;
    if (spaces && wider && middle.volume + added <= most * middle.volume) {
      *bounds.upper_volume += added;
      for (std::size_t i = 0; i < closures.size(); ++i) {
        add_tip((*wider)[i], closures[i], kSideSlacks * behind.slack(closures[i]), size);
        beyond.insert(beyond.end(), (*wider)[i].points.begin(), (*wider)[i].points.end());
      }
    } else {
      bounds.upper_volume.reset();
    }
    bounds.hollows = possible_hollows(surface, closures, closure_of);
  }
  if (parts.uncertainty != nullptr) {
    bounds.lower_volume -= parts.uncertainty->volume_below;
    if (bounds.upper_volume) *bounds.upper_volume += parts.uncertainty->volume_above;
  }
  bounds.lower_volume = std::max(bounds.lower_volume, kMinLeftByIndentation * middle.volume);
  for (const PossibleHollow& hollow : bounds.hollows) bounds.lower_volume -= hollow.volume;
  bounds.lower_volume = std::max(bounds.lower_volume, kMinLeftByHollows * middle.volume);
  if (!bounds.upper_volume) return bounds;
  const std::vector<Vec3> observed =
      parts.uncertainty != nullptr ? parts.uncertainty->inner_points : observed_points(surface);
  std::vector<Vec3> possible =
      parts.uncertainty != nullptr ? parts.uncertainty->outer_points : observed;
  possible.insert(possible.end(), beyond.begin(), beyond.end());
  bounds.sides = bound_box_sides(observed, possible);
  if (parts.uncertainty != nullptr) {
    const Vec3 both_ends = Vec3::Constant(2.0 * parts.uncertainty->extent_error);
    bounds.sides->lower = (bounds.sides->lower - both_ends).cwiseMax(0.0);
    bounds.sides->upper += both_ends;
  }
  return bounds;
}

std::vector<std::string> describe_hollows(const std::vector<PossibleHollow>& hollows, double unit) {
  std::vector<std::string> notes;
  for (const PossibleHollow& hollow : hollows) {
    const std::string width = format_significant(hollow.width * unit, 2) + " m wide";
    notes.push_back(
        hollow.other_opening
            ? "a tunnel may connect the unobserved areas near " + format_point(hollow.position) +
                  " and " + format_point(*hollow.other_opening) + ", " + width +
                  ": the surface turns inwards around both, and the lower bound of volume excludes "
                  "it; "
                  "scan its walls, or weigh the block"
            : "a cavity may lie behind the unobserved area near " + format_point(hollow.position) +
                  ", " + width +
                  ": the surface turns inwards around it, and the lower bound of volume excludes "
                  "the rock straight behind it; scan its walls, or weigh the block");
  }
  return notes;
}

}  // namespace clast::reconstruct_detail
