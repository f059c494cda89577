#include "study/barrier.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clast {
namespace {

// Crossing times in contact are found to this, s.
constexpr double kTimeTolerance = 1e-9;

// A centre exactly on the plane counts as right of it, so that a path is split at the plane once.
bool is_left(double distance) { return distance > 0.0; }

/// @param closed  the point at `to` belongs to the segment
std::optional<Crossing> crossing_of_segment(const Vec2& from, const Vec2& to, bool closed,
                                            const RigidBody& body, const MotionStep& step,
                                            const TerrainSurface& terrain, double gravity) {
  const Vec2 span = to - from;
  const double length = span.norm();
  const Vec2 along = span / length;
  const Vec2 left(-along.y(), along.x());
  const auto distance_left = [&](const RigidState& state) {
    return left.dot(state.position.head<2>() - from);
  };
  const double begin = distance_left(step.begin);
  const double end = distance_left(step.end);
  if (is_left(begin) == is_left(end)) return std::nullopt;

  Crossing crossing;
  crossing.forward = is_left(begin);
  RigidState state;
  const double duration = step.end_time - step.begin_time;
  if (step.flight) {
    const double elapsed = std::clamp(begin / (begin - end), 0.0, 1.0) * duration;
    crossing.time = step.begin_time + elapsed;
    state = free_flight(body, step.begin, elapsed, gravity);
  } else {
    double before = step.begin_time, after = step.end_time;
    while (after - before > kTimeTolerance) {
      const double middle = 0.5 * (before + after);
      if (middle <= before || middle >= after) break;
      const double distance = distance_left(state_at(body, step, middle, gravity));
      (is_left(distance) == is_left(begin) ? before : after) = middle;
    }
    crossing.time = after;
    state = state_at(body, step, after, gravity);
  }

  const double reach = along.dot(state.position.head<2>() - from);
  if (reach < 0.0 || reach > length || (reach == length && !closed)) return std::nullopt;
  const Vec3& centre = state.position;
  const std::optional<double> ground = terrain.height(centre.x(), centre.y(), centre.z());
  if (!ground) return std::nullopt;

  const Pose world_from_body = state.world_from_body();
  Vec3 lowest = world_from_body * body.shape.vertices.front();
  for (const Vec3& vertex : body.shape.vertices) {
    const Vec3 point = world_from_body * vertex;
    if (point.z() < lowest.z()) lowest = point;
  }
  lowest.z() -= body.shape.radius;
  crossing.position = centre;
  crossing.velocity = state.velocity;
  crossing.angular_velocity = state.angular_velocity;
  crossing.height = centre.z() - *ground;
  crossing.clearance =
      lowest.z() - terrain.height(lowest.x(), lowest.y(), lowest.z()).value_or(*ground);
  crossing.translational_energy = translational_energy(body, state);
  crossing.rotational_energy = rotational_energy(body, state);
  return crossing;
}

}  // namespace

std::vector<Crossing> find_crossings(const Barrier& barrier, const RigidBody& body,
                                     const MotionStep& step, const TerrainSurface& terrain,
                                     double gravity) {
  std::vector<Crossing> found;
  for (std::size_t i = 0; i + 1 < barrier.through.size(); ++i) {
    const bool last = i + 2 == barrier.through.size();
    if (const std::optional<Crossing> crossing = crossing_of_segment(
            barrier.through[i], barrier.through[i + 1], last, body, step, terrain, gravity)) {
      found.push_back(*crossing);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
  return found;
}

}  // namespace clast
