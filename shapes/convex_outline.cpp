#include "shapes/convex_outline.hpp"

#include <algorithm>
#include <utility>

#include "mesh/plan_geometry.hpp"

namespace clast {
namespace {

bool is_before_in_plane(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace

std::vector<Vec2> convex_hull_2d(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), is_before_in_plane);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Monotone chain: the lower outline forward, the upper one back.
  std::vector<Vec2> outline(2 * points.size());
  std::size_t size = 0;
  for (const Vec2& p : points) {
    while (size >= 2 && twice_area(outline[size - 2], outline[size - 1], p) <= 0.0) --size;
    outline[size++] = p;
  }
  const std::size_t lower = size + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    while (size >= lower && twice_area(outline[size - 2], outline[size - 1], points[i]) <= 0.0)
      --size;
    outline[size++] = points[i];
  }
  outline.resize(size - 1);
  return outline;
}

std::vector<Vec2> remove_reflex_vertices(std::vector<Vec2> loop) {
  if (loop.size() < 3) return convex_hull_2d(std::move(loop));
  // Starts at a point that is certainly a corner, so that no earlier one has to be removed.
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), is_before_in_plane),
              loop.end());
  const Vec2 start = loop.front();
  std::size_t size = 1;
  const auto drop_behind = [&](const Vec2& p) {
    while (size >= 2 && twice_area(loop[size - 2], loop[size - 1], p) <= 0.0) --size;
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

}  // namespace clast
