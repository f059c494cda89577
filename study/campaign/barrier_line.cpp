#include "study/campaign/barrier_line.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast {
namespace {

// Segments nearer than this touch, m; far above the rounding of coordinates, below survey accuracy.
constexpr double kTouch = 1e-6;

struct Segment {
  Vec2 from, to;

  Vec2 low() const { return from.cwiseMin(to); }
  Vec2 high() const { return from.cwiseMax(to); }
  Vec2 closest(const Vec2& point) const {
    const Vec2 along = to - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return from + share * along;
  }
};

/// A place where both segments are.
std::optional<Vec2> meeting(const Segment& a, const Segment& b) {
  const Vec2 r = a.to - a.from, s = b.to - b.from, between = b.from - a.from;
  const double sine = cross(r, s);
  if (sine != 0.0) {
    const double of_a = cross(between, s) / sine, of_b = cross(between, r) / sine;
    if (of_a >= 0.0 && of_a <= 1.0 && of_b >= 0.0 && of_b <= 1.0) return a.from + of_a * r;
  }
  for (const Vec2& end : {b.from, b.to}) {
    if ((a.closest(end) - end).norm() < kTouch) return end;
  }
  for (const Vec2& end : {a.from, a.to}) {
    if ((b.closest(end) - end).norm() < kTouch) return end;
  }
  return std::nullopt;
}

/// `before` ends where `after` begins; the end of the shorter one that lies on the longer one.
std::optional<Vec2> retraced(const Segment& before, const Segment& after) {
  const Vec2 back = before.from - before.to, on = after.to - after.from;
  if (!(back.dot(on) > 0.0)) return std::nullopt;
  const Vec2 end = back.norm() < on.norm() ? before.from : after.to;
  const Segment& longer = back.norm() < on.norm() ? after : before;
  if ((longer.closest(end) - end).norm() < kTouch) return end;
  return std::nullopt;
}

}  // namespace

bool is_ring(std::span<const Vec2> line) { return line.size() > 3 && line.front() == line.back(); }

bool is_counter_clockwise(std::span<const Vec2> ring) { return signed_area(ring) > 0.0; }

std::optional<LineSelfIntersection> find_line_self_intersection(std::span<const Vec2> line) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) segments.push_back({line[i], line[i + 1]});
  const std::size_t count = segments.size();
  const bool ring = is_ring(line);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return segments[a].low().x() < segments[b].low().x();
  });
  std::optional<LineSelfIntersection> first;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) {
      const auto [a, b] = std::minmax(order[i], order[k]);
      if (segments[order[k]].low().x() > segments[order[i]].high().x() + kTouch) break;
      if (segments[a].low().y() > segments[b].high().y() + kTouch ||
          segments[b].low().y() > segments[a].high().y() + kTouch) {
        continue;
      }
      const std::optional<Vec2> found = b == a + 1 ? retraced(segments[a], segments[b])
                                        : ring && a == 0 && b + 1 == count
                                            ? retraced(segments[b], segments[a])
                                            : meeting(segments[a], segments[b]);
      if (!found || (first && std::pair(first->first, first->second) < std::pair(a, b))) continue;
      first = {a, b, *found};
    }
  }
  return first;
}

void check_barrier_line(std::span<const Vec2> line) {
  const std::optional<LineSelfIntersection> found = find_line_self_intersection(line);
  if (!found) return;
  throw InputError("segments " + std::to_string(found->first + 1) + " and " +
                   std::to_string(found->second + 1) + " meet at (" +
                   format_significant(found->position.x(), 9) + ", " +
                   format_significant(found->position.y(), 9) +
                   "); a barrier must not cross, touch or retrace itself, apart from a ring, whose "
                   "last point is its first: make two barriers of it");
}

}  // namespace clast
