#include "study/campaign/barrier.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "mesh/plan_geometry.hpp"
#include "study/campaign/barrier_line.hpp"

namespace clast {
namespace {

// Crossing times in contact are found to this, s.
constexpr double kTimeTolerance = 1e-9;

// A centre exactly on the plane counts as right of it, so that a path is split at the plane once.
bool is_left(double distance) { return distance > 0.0; }

/// A step's way through the plane over a segment's whole line.
struct SegmentPassage {
  double time = 0.0;  ///< s
  RigidState state;
  bool from_left = false;
};

/// One at most, also where the plane is passed beside the segment.
std::optional<SegmentPassage> passage(const Vec2& from, const Vec2& to, const RigidBody& body,
                                      const MotionStep& step, double gravity) {
  const Vec2 span = to - from;
  const Vec2 along = span / span.norm();
  const Vec2 left(-along.y(), along.x());
  const auto distance_left = [&](const RigidState& state) {
    return left.dot(state.position.head<2>() - from);
  };
  const double begin = distance_left(step.begin);
  const double end = distance_left(step.end);
  if (is_left(begin) == is_left(end)) return std::nullopt;

  SegmentPassage found;
  found.from_left = is_left(begin);
  const double duration = step.end_time - step.begin_time;
  if (step.flight) {
    const double elapsed = std::clamp(begin / (begin - end), 0.0, 1.0) * duration;
    found.time = step.begin_time + elapsed;
    found.state = free_flight(body, step.begin, elapsed, gravity);
  } else {
    double before = step.begin_time, after = step.end_time;
    while (after - before > kTimeTolerance) {
      const double middle = 0.5 * (before + after);
      if (middle <= before || middle >= after) break;
      const double distance = distance_left(interpolate_state(body, step, middle, gravity));
      (is_left(distance) == is_left(begin) ? before : after) = middle;
    }
    found.time = after;
    found.state = interpolate_state(body, step, after, gravity);
  }
  return found;
}

/// Measures a passage; empty outside surveyed ground.
std::optional<Crossing> crossing_at(double time, const RigidState& state, bool forward,
                                    const RigidBody& body, const TerrainSurface& terrain) {
  const Vec3& centre = state.position;
  const std::optional<double> ground = terrain.height_at(centre.x(), centre.y(), centre.z());
  if (!ground) return std::nullopt;

  Crossing crossing;
  crossing.forward = forward;
  crossing.time = time;
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
      lowest.z() - terrain.height_at(lowest.x(), lowest.y(), lowest.z()).value_or(*ground);
  crossing.translational_energy = translational_energy(body, state);
  crossing.rotational_energy = rotational_energy(body, state);
  return crossing;
}

std::vector<Crossing> crossings_of_line(const Barrier& barrier, const RigidBody& body,
                                        const MotionStep& step, const TerrainSurface& terrain,
                                        double gravity) {
  std::vector<Crossing> found;
  for (std::size_t i = 0; i + 1 < barrier.vertices.size(); ++i) {
    const Vec2 &from = barrier.vertices[i], &to = barrier.vertices[i + 1];
    const std::optional<SegmentPassage> passed = passage(from, to, body, step, gravity);
    if (!passed) continue;
    const double length = (to - from).norm();
    const double reach = ((to - from) / length).dot(passed->state.position.head<2>() - from);
    const bool last = i + 2 == barrier.vertices.size();  // its end belongs to it
    if (reach < 0.0 || reach > length || (reach == length && !last)) continue;
    if (const std::optional<Crossing> crossing =
            crossing_at(passed->time, passed->state, passed->from_left, body, terrain)) {
      found.push_back(*crossing);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
  return found;
}

/// A step can go in or out only where it passes the line of a side, so it is looked whether it is
/// inside before, between and after these instants: entries and exits alternate, whatever corner is
/// grazed and however it is rounded.
std::vector<Crossing> crossings_of_ring(const Barrier& barrier, const RigidBody& body,
                                        const MotionStep& step, const TerrainSurface& terrain,
                                        double gravity) {
  std::vector<Crossing> found;
  const std::vector<Vec2>& ring = barrier.vertices;
  std::vector<SegmentPassage> passed;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    if (auto one = passage(ring[i], ring[i + 1], body, step, gravity)) passed.push_back(*one);
  }
  std::stable_sort(
      passed.begin(), passed.end(),
      [](const SegmentPassage& a, const SegmentPassage& b) { return a.time < b.time; });
  // A begin on the line itself can belong to the other side.
  if (passed.empty()) passed.push_back({step.begin_time, step.begin, false});
  bool inside = is_inside(ring, step.begin.position.head<2>());
  for (std::size_t i = 0; i < passed.size(); ++i) {
    const RigidState after =
        i + 1 < passed.size()
            ? interpolate_state(body, step, 0.5 * (passed[i].time + passed[i + 1].time), gravity)
            : step.end;
    if (is_inside(ring, after.position.head<2>()) == inside) continue;
    // A crossing from left to right leaves a ring with its inside on the left.
    const bool forward = inside == is_counter_clockwise(ring);
    inside = !inside;
    if (const std::optional<Crossing> crossing =
            crossing_at(passed[i].time, passed[i].state, forward, body, terrain)) {
      found.push_back(*crossing);
    }
  }
  return found;
}

}  // namespace

CountedDirection parse_counted_direction(const std::string& name) {
  if (name == "either") return CountedDirection::kEither;
  if (name == "forward") return CountedDirection::kForward;
  throw InputError("\"" + name + "\" is unknown; use either or forward");
}

std::string name_of(CountedDirection crossings) {
  return crossings == CountedDirection::kForward ? "forward" : "either";
}

std::vector<Crossing> find_crossings(const Barrier& barrier, const RigidBody& body,
                                     const MotionStep& step, const TerrainSurface& terrain,
                                     double gravity) {
  return is_ring(barrier.vertices) ? crossings_of_ring(barrier, body, step, terrain, gravity)
                                   : crossings_of_line(barrier, body, step, terrain, gravity);
}

}  // namespace clast
