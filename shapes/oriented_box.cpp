#include "shapes/oriented_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/axis_sign.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/detail/calipers.hpp"
#include "shapes/detail/gauss_image.hpp"

namespace clast {
namespace {

// About so many directions are looked at on the Gauss image of a hull before the best are refined.
constexpr double kDirections = 4000.0;
constexpr double kFinestStep = 0.002;  // rad
constexpr std::size_t kRefined = 48;
// A direction is dropped unseen only if its lower bound is this much above the best box.
constexpr double kMargin = 1.02;
// Volumes closer than this are equal; area and length decide.
constexpr double kVolumeTie = 1e-11;
// An extent below this share of the largest is rounding.
constexpr double kFlatBox = 1e-12;
constexpr int kFirstGoldenSteps = 12, kGoldenSteps = 28;
constexpr int kFirstRounds = 3, kBoxRounds = 60;
// After the first steps a candidate this much above the lowest can't become the lowest any more:
// they leave it a hundredth of a step from its minimum.
constexpr double kRunningMargin = 1.001;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check_points(std::span<const Vec3> points, double radius) {
  if (points.empty()) throw GeometryError("box: there are no points to put one around");
  for (const Vec3& p : points) {
    if (!p.allFinite()) throw GeometryError("box: a point has coordinates that are not finite");
  }
  if (!(radius >= 0.0) || !std::isfinite(radius)) {
    throw InputError("box: radius " + format_significant(radius, 6) +
                     " m must be zero or positive");
  }
}

/// A place on an arc, and half the distance to the next that was looked at.
struct Candidate {
  double volume;
  std::size_t edge;
  double share, reach;
};

/// Looks at every face and along every edge's arc: some smallest box has two adjacent sides flush
/// with edges (O'Rourke 1985), so one of its axes is on an arc, and the calipers find the rest.
std::vector<Candidate> scan_gauss_image(GaussImage& hull) {
  double total = 0.0;
  for (std::size_t e = 0; e < hull.edge_count(); ++e) total += hull.arc_length(e);
  const double step = std::max(total / kDirections, kFinestStep);

  double best = kInfinity;
  std::vector<double> face_volume(hull.face_count());
  std::vector<std::size_t> order(hull.face_count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return hull.face_area(a) > hull.face_area(b);
  });
  for (const std::size_t f : order) {
    face_volume[f] = hull.smallest_box_along(hull.normal(f), kMargin * best).volume;
    best = std::min(best, face_volume[f]);
  }
  std::vector<Candidate> candidates;
  std::vector<double> volumes;
  for (std::size_t e = 0; e < hull.edge_count(); ++e) {
    const auto pieces =
        static_cast<std::size_t>(std::max(1.0, std::ceil(hull.arc_length(e) / step)));
    const double reach = 1.0 / static_cast<double>(pieces);
    volumes.assign(1, face_volume[hull.edge_faces(e)[0]]);
    for (std::size_t i = 1; i < pieces; ++i) {
      const Vec3 direction = hull.point_on_arc(e, static_cast<double>(i) * reach);
      volumes.push_back(hull.smallest_box_along(direction, kMargin * best).volume);
      best = std::min(best, volumes.back());
    }
    volumes.push_back(face_volume[hull.edge_faces(e)[1]]);
    for (std::size_t i = 0; i <= pieces; ++i) {
      const bool lowest =
          (i == 0 || volumes[i] <= volumes[i - 1]) && (i == pieces || volumes[i] <= volumes[i + 1]);
      if (lowest && volumes[i] <= kMargin * best) {
        candidates.push_back({volumes[i], e, static_cast<double>(i) * reach, reach});
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.volume < b.volume; });
  return candidates;
}

/// A candidate with the lowest posture that was met near it.
struct Refined {
  Candidate candidate;
  BoxCandidate posture;
};

/// Golden section on the candidate's arc: so many steps nearer to the lowest posture within reach.
Refined refined(GaussImage& hull, const Candidate& candidate, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  double low = std::max(0.0, candidate.share - candidate.reach);
  double high = std::min(1.0, candidate.share + candidate.reach);
  Refined best = {candidate, {}};
  const auto look = [&](double share) {
    const BoxCandidate posture =
        hull.smallest_box_along(hull.point_on_arc(candidate.edge, share), kInfinity);
    if (posture.volume < best.posture.volume) {
      best.posture = posture;
      best.candidate.share = share;
    }
    return posture.volume;
  };
  look(candidate.share);
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = look(left), at_right = look(right);
  for (int i = 0; i < steps; ++i) {
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = look(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = look(right);
    }
  }
  best.candidate.volume = best.posture.volume;
  best.candidate.reach = high - low;
  return best;
}

/// Calipers about the three axes in turn until none makes the box smaller, or so many times: off an
/// arc's minimum the gains can become ever smaller without an end.
BoxCandidate settled(GaussImage& hull, BoxCandidate posture, int rounds) {
  bool smaller = true;
  for (int round = 0; smaller && round < rounds; ++round) {
    smaller = false;
    for (int axis = 0; axis < 3; ++axis) {
      const BoxCandidate next = hull.smallest_box_along(posture.axes.col(axis), kInfinity);
      if (next.volume < posture.volume * (1.0 - 1e-14)) {
        posture = next;
        smaller = true;
      }
    }
  }
  return posture;
}

double box_area(const OrientedBox& box) {
  const Vec3& l = box.lengths;
  return 2.0 * (l[0] * l[1] + l[1] * l[2] + l[2] * l[0]);
}

/// Around points of a plane, a line or one place.
OrientedBox flat_box(std::span<const Vec3> points, const AffineSpan& span, double radius) {
  Mat3 axes = span.axes;
  if (span.dimension == 2) {
    std::vector<Vec2> plane;
    for (const Vec3& p : points) {
      const Vec3 local = p - points.front();
      plane.emplace_back(axes.col(0).dot(local), axes.col(1).dot(local));
    }
    const Vec2 direction = smallest_rectangle(std::move(plane), radius).direction;
    const Vec3 along = direction.x() * axes.col(0) + direction.y() * axes.col(1);
    axes.col(0) = along.normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
  }
  OrientedBox box = box_with_axes(points, axes, radius);
  for (int i = span.dimension; i < 3; ++i) box.lengths[i] = 2.0 * radius;
  return box;
}

}  // namespace

bool is_smaller(const OrientedBox& a, const OrientedBox& b) {
  if (std::abs(a.volume() - b.volume()) > kVolumeTie * b.volume()) return a.volume() < b.volume();
  if (std::abs(box_area(a) - box_area(b)) > kVolumeTie * box_area(b))
    return box_area(a) < box_area(b);
  return a.lengths[0] < b.lengths[0] * (1.0 - kVolumeTie);
}

OrientedBox box_with_axes(std::span<const Vec3> points, const Mat3& axes, double radius) {
  check_points(points, radius);
  // Relative to a point, so that large coordinates keep their digits.
  const Vec3 origin = points.front();
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  for (const Vec3& p : points) {
    const Vec3 local = axes.transpose() * (p - origin);
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  Vec3 extents = high - low;
  for (double& extent : extents) extent = extent > kFlatBox * extents.maxCoeff() ? extent : 0.0;
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return extents[a] > extents[b]; });

  OrientedBox box;
  box.centre = origin + axes * (0.5 * (low + high));
  for (int i = 0; i < 3; ++i) box.lengths[i] = extents[order[i]] + 2.0 * radius;
  box.axes.col(0) = with_largest_component_positive(axes.col(order[0]));
  box.axes.col(1) = with_largest_component_positive(axes.col(order[1]));
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  return box;
}

OrientedBox smallest_box(std::span<const Vec3> points, double radius) {
  check_points(points, radius);
  const std::vector<Vec3> sorted = sorted_unique_points(points);
  const AffineSpan span = affine_span(sorted);
  if (span.dimension < 3) return flat_box(sorted, span, radius);

  TriangleMesh mesh = convex_hull(sorted);
  const Bounds around = bounds(mesh);
  const Vec3 middle = 0.5 * (around.low + around.high);
  for (Vec3& v : mesh.vertices) v -= middle;
  GaussImage hull(mesh, radius);

  // All of the best a little, then those that are still in the running to the end.
  std::vector<Refined> running;
  double lowest = kInfinity;
  const std::vector<Candidate> candidates = scan_gauss_image(hull);
  for (std::size_t i = 0; i < std::min(kRefined, candidates.size()); ++i) {
    running.push_back(refined(hull, candidates[i], kFirstGoldenSteps));
    running.back().posture = settled(hull, running.back().posture, kFirstRounds);
    lowest = std::min(lowest, running.back().posture.volume);
  }
  OrientedBox best;
  bool first = true;
  for (const Refined& start : running) {
    if (start.posture.volume > kRunningMargin * lowest) continue;
    const Refined end = refined(hull, start.candidate, kGoldenSteps);
    const BoxCandidate posture = settled(hull, end.posture, kBoxRounds);
    const Mat3& axes = posture.volume < start.posture.volume ? posture.axes : start.posture.axes;
    const OrientedBox box = box_with_axes(mesh.vertices, axes, radius);
    if (first || is_smaller(box, best)) best = box;
    first = false;
  }
  best.centre += middle;
  return best;
}

OrientedBox smallest_box(const SpheroPolyhedron& body) {
  return smallest_box(body.vertices, body.radius);
}

}  // namespace clast
