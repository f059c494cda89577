#include "shapes/detail/calipers.hpp"

#include <algorithm>
#include <cmath>

namespace clast {
namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Corners closer than this share of the outline's size are one: the direction between them is
/// rounding.
constexpr double kOneCorner = 1e-12;
/// A step of the calipers loses this share of the size by rounding alone.
constexpr double kRounding = 1e-14;

/// The outline with corners that are one but for rounding taken once.
std::vector<Vec2> distinct(std::span<const Vec2> outline, double size) {
  std::vector<Vec2> corners;
  const auto apart = [&](const Vec2& a, const Vec2& b) {
    return (a - b).cwiseAbs().maxCoeff() > kOneCorner * size;
  };
  for (const Vec2& corner : outline) {
    if (corners.empty() || apart(corner, corners.back())) corners.push_back(corner);
  }
  while (corners.size() > 1 && !apart(corners.front(), corners.back())) corners.pop_back();
  return corners;
}

double size_of(std::span<const Vec2> outline) {
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Vec2& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return outline.empty() ? 0.0 : (high - low).maxCoeff();
}

bool before(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace

std::vector<Vec2> convex_outline(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Monotone chain: the lower outline forward, the upper one back.
  std::vector<Vec2> outline(2 * points.size());
  std::size_t size = 0;
  for (const Vec2& p : points) {
    while (size >= 2 && turn(outline[size - 2], outline[size - 1], p) <= 0.0) --size;
    outline[size++] = p;
  }
  const std::size_t lower = size + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    while (size >= lower && turn(outline[size - 2], outline[size - 1], points[i]) <= 0.0) --size;
    outline[size++] = points[i];
  }
  outline.resize(size - 1);
  return outline;
}

std::vector<Vec2> convex_loop(std::vector<Vec2> loop) {
  if (loop.size() < 3) return convex_outline(std::move(loop));
  // From a point that is certainly a corner, so that none before it has to be undone.
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), before), loop.end());
  const Vec2 start = loop.front();
  std::size_t size = 1;
  const auto drop_behind = [&](const Vec2& p) {
    while (size >= 2 && turn(loop[size - 2], loop[size - 1], p) <= 0.0) --size;
  };
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const Vec2 p = loop[i];
    drop_behind(p);
    if (p != loop[size - 1]) loop[size++] = p;
  }
  drop_behind(start);
  loop.resize(size);
  return loop;
}

Rectangle smallest_rectangle(std::vector<Vec2> points, double radius) {
  return smallest_rectangle_of_outline(convex_outline(std::move(points)), radius);
}

Rectangle smallest_rectangle_of_outline(std::span<const Vec2> corners, double radius) {
  const double size = size_of(corners);
  const std::vector<Vec2> outline = distinct(corners, size);
  const std::size_t count = outline.size();
  Rectangle best;
  best.along = best.across = 2.0 * radius;
  if (count < 2) return best;

  const auto next = [count](std::size_t i) { return i + 1 == count ? 0 : i + 1; };
  // Farthest points ahead, behind and across; they only move on while the edge turns once around.
  // A step that gains nothing is taken too, or points that tie would hold them back.
  std::size_t ahead = 0, behind = 0, across = 0;
  const auto advance = [&](std::size_t& i, const Vec2& direction) {
    for (std::size_t steps = 0; steps < count; ++steps) {
      if (direction.dot(outline[next(i)] - outline[i]) < -kRounding * size) break;
      i = next(i);
    }
  };
  bool first = true;
  for (std::size_t edge = 0; edge < count; ++edge) {
    const Vec2 direction = (outline[next(edge)] - outline[edge]).normalized();
    const Vec2 inward(-direction.y(), direction.x());
    if (first) {
      for (std::size_t i = 1; i < count; ++i) {
        if (direction.dot(outline[i] - outline[ahead]) > 0.0) ahead = i;
        if (direction.dot(outline[i] - outline[behind]) < 0.0) behind = i;
        if (inward.dot(outline[i] - outline[across]) > 0.0) across = i;
      }
    }
    advance(ahead, direction);
    advance(across, inward);
    advance(behind, -direction);
    Rectangle candidate;
    candidate.direction = direction;
    candidate.along = direction.dot(outline[ahead] - outline[behind]) + 2.0 * radius;
    candidate.across = inward.dot(outline[across] - outline[edge]) + 2.0 * radius;
    if (first || candidate.area() < best.area()) best = candidate;
    first = false;
  }
  return best;
}

}  // namespace clast
