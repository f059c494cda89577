#include "shapes/detail/deviation_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast::shapes_detail {

namespace {

/// Accuracy of the bounds, as a fraction of the scan's diagonal.
constexpr double kGap = 2e-5;
/// Part of that accuracy that patches are settled with.
constexpr double kSettled = 0.5;
/// Height above the plane of a core face up to which a point lies in it, as a fraction of the
/// diagonal.
constexpr double kInFacePlane = 1e-9;
/// Number of patches after which the search ends with the bound that it has.
constexpr std::size_t kMaxPatches = 1'000'000;
/// Fraction of the radius by which a point may lie inside the body and still count as on its
/// surface.
constexpr double kOnCoreSkin = 1e-9, kNearCoreSkin = 1e-6;
/// Patches that are bounded with the same known distance, and open patches that are divided at a
/// time. The results depend on these numbers, so they are constants.
constexpr std::size_t kBatch = 1024, kDivided = 32;
constexpr std::size_t kChunk = 32;       ///< patches or points that one thread takes at a time
constexpr std::size_t kMaxDistant = 64;  ///< points returned for each surface
/// Ratio of the squared lengths of the longest and shortest side above which a patch is thin.
constexpr double kThin = 4.0;

/// Unit directions of the edges that leave each vertex.
std::vector<std::vector<Vec3>> edge_directions(const TriangleMesh& core) {
  std::vector<std::vector<Vec3>> result(core.vertices.size());
  for (const TriangleMesh::Triangle& t : core.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 edge = core.vertices[t[(k + 1) % 3]] - core.vertices[t[k]];
      if (edge.squaredNorm() > 0.0) result[t[k]].push_back(edge.normalized());
    }
  }
  return result;
}

/// Selects points that are at least `spacing` apart, the farthest from the other surface first.
std::vector<Vec3> select_spaced(std::vector<std::pair<double, Vec3>> points, double spacing) {
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Vec3> selected;
  for (const auto& [distance, point] : points) {
    const bool spaced = std::all_of(selected.begin(), selected.end(), [&](const Vec3& other) {
      return (other - point).squaredNorm() >= spacing * spacing;
    });
    if (spaced) selected.push_back(point);
    if (selected.size() == kMaxDistant) break;
  }
  return selected;
}

}  // namespace

/// A triangle of a surface on which the distance to another is to be bounded: corners on a core,
/// each carried `radius` along its unit direction. A flat triangle has radius 0.
struct DeviationSearch::Patch {
  std::array<Vec3, 3> points, directions;
  std::uint32_t vertex = kNoVertex;  ///< of the core, for patches of the ball about it
  std::uint32_t core_triangle = 0;   ///< near the patch, for patches of a body
  std::uint32_t near = 0;            ///< a triangle of the other surface that was closest
  double most = 1e300;               ///< bound of the patch that this is a part of, m

  static constexpr std::uint32_t kNoVertex = 0xffffffffu;

  Vec3 foot() const { return (points[0] + points[1] + points[2]) / 3.0; }
  Vec3 direction() const { return (directions[0] + directions[1] + directions[2]).normalized(); }
  /// Returns the corners of the flat triangle that the patch is near.
  std::array<Vec3, 3> corners(double radius) const {
    return {points[0] + radius * directions[0], points[1] + radius * directions[1],
            points[2] + radius * directions[2]};
  }
  double spread_of_directions() const {
    const Vec3 middle = direction();
    double result = 0.0;
    for (const Vec3& d : directions) result = std::max(result, (d - middle).norm());
    return result;
  }
  /// Returns the largest distance of the patch from its flat triangle.
  double sagitta(double radius) const {
    if (radius == 0.0) return 0.0;
    const double spread = spread_of_directions();
    return 0.5 * radius * spread * spread;
  }
  /// Returns an upper bound of the distances of the patch from `centre`.
  double reach(const Vec3& centre, double radius) const {
    double result = 0.0;
    for (const Vec3& corner : corners(radius)) result = std::max(result, (corner - centre).norm());
    return result + sagitta(radius);
  }
  /// Returns an upper bound of the distances of the patch from triangle `t` of `tree`. The distance
  /// from something convex is largest at a corner of the flat triangle.
  double farthest_from(const TriangleTree& tree, std::uint32_t t, double radius) const {
    double result = 0.0;
    for (const Vec3& corner : corners(radius))
      result = std::max(result, tree.distance_to(t, corner));
    return result + sagitta(radius);
  }
  /// Appends the parts of the patch: halves if it is long and thin, quarters otherwise.
  void append_parts(double radius, std::vector<Patch>& parts) const {
    const std::array<Vec3, 3> corner = corners(radius);
    std::array<Vec3, 3> p, d;         // middle of the side from corner k to k + 1
    std::array<double, 3> lengths{};  // squared
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      p[k] = 0.5 * (points[k] + points[next]);
      d[k] = (directions[k] + directions[next]).normalized();
      lengths[k] = (corner[next] - corner[k]).squaredNorm();
    }
    const auto append = [&](const std::array<Vec3, 3>& feet, const std::array<Vec3, 3>& ways) {
      parts.push_back({feet, ways, vertex, core_triangle, near, most});
    };
    const auto longest = std::max_element(lengths.begin(), lengths.end());
    if (*longest > kThin * *std::min_element(lengths.begin(), lengths.end())) {
      const auto k = static_cast<std::size_t>(longest - lengths.begin());
      const std::size_t next = (k + 1) % 3, other = (k + 2) % 3;
      append({points[k], p[k], points[other]}, {directions[k], d[k], directions[other]});
      append({p[k], points[next], points[other]}, {d[k], directions[next], directions[other]});
      return;
    }
    append({points[0], p[0], p[2]}, {directions[0], d[0], d[2]});
    append({points[1], p[1], p[0]}, {directions[1], d[1], d[0]});
    append({points[2], p[2], p[1]}, {directions[2], d[2], d[1]});
    append(p, d);
  }
};

/// Bounds of the distances of one patch, m.
struct DeviationSearch::PatchBound {
  Vec3 centre = Vec3::Zero();
  double at_centre = 0.0;  ///< distance of the centre, if `counts`
  double most = 0.0;       ///< upper bound; negative if no point of the patch is on the surface
  bool counts = true;      ///< true if the centre is a point of the surface
};

struct DeviationSearch::Outcome {
  double largest = 0.0;  ///< upper bound of the largest distance, m
  std::vector<std::pair<double, Vec3>>
      noted;  ///< distances above `Limits::noted`, and their points
};

DeviationSearch::DeviationSearch(const ScanSurface& scan, const TriangleMesh& core, double radius,
                                 ThreadPool& threads)
    : scan_(scan),
      core_(core),
      radius_(radius),
      threads_(threads),
      tree_(core),
      surface_(tree_, radius,
               [&] {
                 Bounds both = bounds(scan.mesh());
                 for (const Vec3& vertex : core.vertices) both.include(vertex);
                 return both.diagonal() + radius;
               }()),
      scan_over_(scan) {
  Bounds both = bounds(scan.mesh());
  gap_ = kGap * both.diagonal();
  for (const Vec3& vertex : core.vertices) both.include(vertex);
  in_plane_ = kInFacePlane * both.diagonal();
}

std::vector<SurfaceDistance> DeviationSearch::distances_from_body(std::span<const Vec3> points) {
  std::vector<SurfaceDistance> distances(points.size());
  const std::size_t chunks = (points.size() + kChunk - 1) / kChunk;
  threads_.run(chunks, 1, [&](std::size_t chunk) {
    std::uint32_t hint = 0;  // neighbours in the list are mostly neighbours in space
    for (std::size_t i = chunk * kChunk; i < std::min(points.size(), (chunk + 1) * kChunk); ++i) {
      distances[i] = surface_(points[i], hint);
    }
  });
  return distances;
}

/// Divides the patches with the largest upper bounds.
template <typename Bound>
DeviationSearch::Outcome DeviationSearch::search(std::vector<Patch> patches, double radius,
                                                 double known, const Limits& limits,
                                                 const Bound& bound) {
  struct Open {
    double most;
    std::size_t index;
    bool operator<(const Open& other) const {
      return most < other.most || (most == other.most && index > other.index);
    }
  };
  Outcome outcome;
  std::priority_queue<Open> open;
  std::vector<PatchBound> found;
  const auto bound_from = [&](std::size_t first) {
    while (first < patches.size()) {
      const std::size_t count = std::min(kBatch, patches.size() - first);
      const double ignored = std::min(known, limits.noted);
      found.resize(count);
      threads_.run(count, kChunk, [&](std::size_t i) {
        Patch& patch = patches[first + i];
        found[i] = bound(patch, ignored);
        // Distances under creases are upper bounds. That of a larger patch may be lower.
        patch.most = found[i].most = std::min(found[i].most, patch.most);
        found[i].at_centre = std::min(found[i].at_centre, patch.most);
      });
      for (std::size_t i = 0; i < count; ++i) {
        if (found[i].counts) {
          known = std::max(known, found[i].at_centre);
          if (found[i].at_centre > limits.noted) {
            outcome.noted.emplace_back(found[i].at_centre, found[i].centre);
          }
        }
        if (found[i].most > known) open.push({found[i].most, first + i});
      }
      first += count;
    }
  };
  bound_from(0);
  const std::size_t first_patches = patches.size();
  const auto is_open = [&] {
    const bool is_refused =
        known > limits.refused && patches.size() >= limits.least_growth * first_patches;
    return !open.empty() && !is_refused &&
           open.top().most > std::max(known + gap_, limits.accepted);
  };
  while (is_open() && patches.size() < kMaxPatches) {
    const std::size_t first = patches.size();
    for (std::size_t i = 0; i < kDivided && is_open(); ++i) {
      const Patch divided = patches[open.top().index];
      open.pop();
      divided.append_parts(radius, patches);
    }
    bound_from(first);
  }
  outcome.largest =
      open.empty() || known > limits.refused ? known : std::max(known, open.top().most);
  return outcome;
}

/// Returns true if no point of a flat patch of the scan is farther than `limit` from the rounded
/// surface. The test uses the plane of the core face nearest to the patch centre, raised by the
/// radius and by what remains of `limit` below it. If no part of the core nearby is within a radius
/// of that plane, it is outside the body over the patch, and a point inside the body is at most its
/// depth below the plane away from the rounded surface.
bool DeviationSearch::is_near_plane(const Patch& patch, double limit) const {
  const Vec3& normal = tree_.face_normal(patch.near);
  const double height = normal.dot(tree_.first_vertex(patch.near));
  double lowest = height + radius_;
  for (const Vec3& point : patch.points) lowest = std::min(lowest, normal.dot(point));
  const double rise = limit - (height + radius_ - lowest);
  if (rise < 0.0) return false;
  if (patch.farthest_from(tree_, patch.near, 0.0) - radius_ > limit) return false;
  const Vec3 centre = patch.foot();
  const Vec3 raised = centre + (radius_ - (normal.dot(centre) - height)) * normal;
  return !tree_.has_point_above(normal, height + rise - in_plane_, raised,
                                patch.reach(centre, 0.0) + radius_ + rise);
}

DeviationSearch::Outcome DeviationSearch::search_scan(double known, const Limits& limits) {
  std::vector<Patch> patches;
  patches.reserve(scan_.mesh().triangles.size());
  const Vec3 none = Vec3::UnitX();
  for (const auto& [a, b, c] : scan_.mesh().triangles) {
    const std::vector<Vec3>& vertices = scan_.mesh().vertices;
    patches.push_back({{vertices[a], vertices[b], vertices[c]}, {none, none, none}});
  }
  return search(std::move(patches), 0.0, known, limits, [&](Patch& patch, double ignored) {
    const double distance = surface_(patch.foot(), patch.near).value;
    const double reach = patch.reach(patch.foot(), 0.0);
    double most = std::abs(distance) + reach;
    if (distance >= reach || radius_ == 0.0) {  // outside of the body everywhere
      most = std::min(most, patch.farthest_from(tree_, patch.near, 0.0) - radius_);
    }
    const double settled = std::max(ignored + kSettled * gap_, limits.accepted);
    if (std::min(most, patch.most) > settled && is_near_plane(patch, settled)) most = settled;
    return PatchBound{patch.foot(), std::abs(distance), most};
  });
}

/// Returns an upper bound of the distance of a patch of the body from the scan, from the heights of
/// the scan over the patch. Returns nothing if that is above `limit`.
std::optional<double> DeviationSearch::bound_by_height(const Patch& patch, double limit) const {
  std::array<Vec3, 3> corners = patch.corners(radius_);
  const auto normal = [&] { return (corners[1] - corners[0]).cross(corners[2] - corners[0]); };
  if (normal().dot(patch.direction()) < 0.0) std::swap(corners[1], corners[2]);
  const double sagitta = patch.sagitta(radius_), length = normal().norm();
  if (!(length > 0.0) || sagitta >= limit) return std::nullopt;
  const auto height = scan_over_(corners, normal() / length, patch.near, limit - sagitta);
  return height ? std::optional(*height + sagitta) : std::nullopt;
}

/// Returns patches that contain the surface of the body: faces moved out, strips over edges, balls
/// over vertices. The search excludes the parts that are buried in the body.
std::vector<DeviationSearch::Patch> DeviationSearch::body_patches() const {
  std::vector<Patch> patches;
  std::vector<Vec3> normals;
  constexpr std::uint32_t kNoVertex = Patch::kNoVertex;
  for (std::uint32_t t = 0; t < core_.triangles.size(); ++t) {
    const auto& [a, b, c] = core_.triangles[t];
    const Vec3 n = unit_normal(core_, core_.triangles[t]);
    normals.push_back(n);
    if (n.isZero()) continue;
    patches.push_back(
        {{core_.vertices[a], core_.vertices[b], core_.vertices[c]}, {n, n, n}, kNoVertex, t});
  }
  if (radius_ == 0.0) return patches;

  const auto strip = [&](const Vec3& p, const Vec3& q, const Vec3& n1, const Vec3& n2,
                         std::uint32_t triangle) {
    patches.push_back({{p, q, q}, {n1, n1, n2}, kNoVertex, triangle});
    patches.push_back({{p, q, p}, {n1, n2, n2}, kNoVertex, triangle});
  };
  const std::vector<HalfEdge> sorted = sorted_half_edges(core_);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 2) return;
    const Vec3& p = core_.vertices[sides[0].from()];
    const Vec3& q = core_.vertices[sides[1].from()];
    const Vec3& n1 = normals[sides[0].triangle];
    const Vec3& n2 = normals[sides[1].triangle];
    const Vec3 along = (q - p).normalized();
    if (n1.isZero() || n2.isZero() || along.dot(n1.cross(n2)) < 0.0) return;  // reflex
    const Vec3 middle = (n1 + n2 + 1e-6 * along.cross(n1)).normalized();
    strip(p, q, n1, middle, sides[0].triangle);
    strip(p, q, middle, n2, sides[1].triangle);
  });

  for (std::uint32_t v = 0; v < core_.vertices.size(); ++v) {
    const Vec3& p = core_.vertices[v];
    for (int octant = 0; octant < 8; ++octant) {
      const Vec3 x = (octant & 1 ? -1.0 : 1.0) * Vec3::UnitX();
      const Vec3 y = (octant & 2 ? -1.0 : 1.0) * Vec3::UnitY();
      const Vec3 z = (octant & 4 ? -1.0 : 1.0) * Vec3::UnitZ();
      patches.push_back({{p, p, p}, {x, y, z}, v});
    }
  }
  return patches;
}

DeviationSearch::Outcome DeviationSearch::search_body(const Limits& limits) {
  const std::vector<std::vector<Vec3>> edges = edge_directions(core_);
  return search(body_patches(), radius_, 0.0, limits, [&](Patch& patch, double ignored) {
    const PatchBound none{Vec3::Zero(), 0.0, -1.0, false};
    if (patch.vertex != Patch::kNoVertex) {
      // The vertex is the closest core point only in directions that lead away from all its edges.
      const Vec3 direction = patch.direction();
      const double spread = patch.spread_of_directions();
      for (const Vec3& edge : edges[patch.vertex]) {
        if (direction.dot(edge) > spread) return none;
      }
    }
    const Vec3 centre = patch.foot() + radius_ * patch.direction();
    const double reach = patch.reach(centre, radius_);
    const TriangleTree::Closest on_scan = scan_.tree().closest_point(centre, patch.near);
    patch.near = on_scan.triangle;
    const double distance = std::sqrt(on_scan.squared_distance);
    double most = std::min(patch.most, distance + reach);
    if (most <= ignored) return none;
    most = std::min(most, patch.farthest_from(scan_.tree(), patch.near, radius_));
    const double settled = std::max(ignored + kSettled * gap_, limits.accepted);
    if (most > settled) {
      most = std::min(most, bound_by_height(patch, settled).value_or(most));
    }
    if (most <= ignored || radius_ == 0.0) return PatchBound{centre, distance, most};
    const TriangleTree::SignedClosest on_core =
        tree_.signed_closest_point(centre, patch.core_triangle);
    const double exposed = (1.0 - kOnCoreSkin) * radius_;
    if (on_core.distance + reach < exposed) return none;
    if (on_core.distance < exposed &&
        patch.farthest_from(tree_, on_core.triangle, radius_) < exposed) {
      return none;
    }
    return PatchBound{centre, distance, most, on_core.distance >= (1.0 - kNearCoreSkin) * radius_};
  });
}

double DeviationSearch::scan_to_body(double known, const Limits& limits) {
  return search_scan(known, limits).largest;
}

double DeviationSearch::body_to_scan(const Limits& limits) { return search_body(limits).largest; }

DeviationSearch::DistantPoints DeviationSearch::find_distant_points(double limit, double distance) {
  const Limits limits{.accepted = limit, .refused = limit, .noted = distance, .least_growth = 2};
  Outcome scan = search_scan(0.0, limits), body = search_body(limits);
  if (std::max(scan.largest, body.largest) <= limit) return {};
  return {select_spaced(std::move(scan.noted), distance),
          select_spaced(std::move(body.noted), distance)};
}

}  // namespace clast::shapes_detail
