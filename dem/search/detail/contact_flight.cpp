// How far or how long no contact can come: what lets a block fly on at once.
#include <algorithm>
#include <array>
#include <cmath>

#include "dem/motion/free_flight.hpp"
#include "dem/search/contact_search.hpp"
#include "dem/search/detail/flying_ball.hpp"

namespace clast::dem_detail {
namespace {

/// The flight of the ball around the block is enough when it is this many times what is worthwhile:
/// less than what a closer search costs.
constexpr double kBallSteps = 16.0;
constexpr double kLongestFlight = 60.0;  ///< s
/// The search for a longer way starts at the first of these numbers of margins and goes on in
/// strides.
constexpr double kFirstLook = 0.125, kLastLook = 8.0, kStride = 4.0;
/// Vertices this far below a plane, m, are on it.
constexpr double kPlaneRounding = 1e-9;

double distance_in(double time, double speed, double acceleration) {
  return time * (speed + 0.5 * acceleration * time);
}

/// How what flies comes to a plane that has the ground on its other side.
struct Approach {
  /// @param away  from the ground, unit
  Approach(const Vec3& away, const FlightBounds& flight)
      : normal(away),
        turn(away.cross(flight.spin)),
        rising(away.dot(flight.velocity)),
        falling(std::max(0.0, away.z() * flight.gravity)) {}
  /// The same for arms in the frame of a body with this rotation.
  Approach in_body(const Mat3& rotation) const {
    Approach result = *this;
    result.normal = rotation.transpose() * normal;
    result.turn = rotation.transpose() * turn;
    return result;
  }

  /// Whether what is `apart` from the plane, m, stays clear of it for a time, s. From its distance
  /// now, its speed and the largest acceleration there is towards the plane.
  /// @param arm      of the point
  /// @param turning  bound of what turning changes its velocity by, m/s^2
  bool clear(double apart, const Vec3& arm, double turning, double time) const {
    const double speed = rising + turn.dot(arm), acceleration = falling + turning;
    return apart >= 0.0 && apart + time * (speed - 0.5 * time * acceleration) >= 0.0;
  }
  /// The time for which it does, where that is not for ever.
  double time(double apart, const Vec3& arm, double turning) const {
    const double speed = rising + turn.dot(arm), acceleration = falling + turning;
    const double root = std::sqrt(speed * speed + 2.0 * acceleration * apart);
    return speed >= 0.0 ? (speed + root) / acceleration : 2.0 * apart / (root - speed);
  }

  Vec3 normal;     ///< away from the ground
  Vec3 turn;       ///< times an arm: the speed away from the plane by the spin
  double rising;   ///< of the centre, m/s
  double falling;  ///< m/s^2
};

/// Beyond a border the ground goes on as a plane.
bool is_at_border(const SurfaceFeatures& surface, std::uint32_t face) {
  const std::array<std::uint32_t, 3>& edges = surface.faces[face].edges;
  return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t edge) {
    return surface.edges[edge].kind == EdgeKind::kBorder;
  });
}

}  // namespace

double ContactSearch::safe_travel() {
  if (touches_ || moved_ < search_at_) return travel_;
  // Measuring what could touch first, and only that, gives how far the block can move; each stride
  // is made only when the one before was clear. At a speed of 1 the time is the distance.
  const FlightBounds creeping{.acceleration = 1e300, .top_speed = 1.0};
  const double first = kFirstLook * margin_;
  double wanted = first, clear = 0.0;
  while (true) {
    clear = wanted;
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      clear = std::min(clear, part_time(p, creeping, wanted));
    }
    if (clear < wanted || wanted >= kLastLook * margin_) break;
    wanted *= kStride;
  }
  if (clear < first) search_at_ = moved_ + 0.5 * clear;
  return travel_ + clear;
}

double ContactSearch::part_time(std::uint32_t p, const FlightBounds& flight, double wanted) {
  const BlockPart& of_block = parts_.parts[p];
  const std::unique_ptr<NearPart>& near = part_states_[p].near;
  const Vec3 velocity = flight.velocity + flight.spin.cross(tests_.rotation() * of_block.centre);
  const double turning = flight.spin.norm() * of_block.radius;
  // By the speed that points of the part have now, or the top speed: the shorter way.
  const auto way_in = [&](double time, double speed) {
    return std::min(distance_in(time, speed + turning, flight.acceleration),
                    distance_in(time, flight.top_speed, flight.gravity));
  };
  const auto time_for = [&](double left, double per_across, double per_along, double speed) {
    const double per_whole = per_across + per_along;
    return std::max(time_over(left, speed + per_whole * turning, per_whole * flight.acceleration),
                    time_over(left, per_whole * flight.top_speed, per_whole * flight.gravity));
  };
  const double speed = velocity.norm(), whole = way_in(wanted, speed);
  if (near) {
    read_way(p);
    renew_ground(p, whole);
  } else if (part_due_[p] < moved_ + whole) {
    update_part(p, moved_ + whole);
  }
  if (!near) {
    const double gap = part_due_[p] - moved_;
    return gap >= whole ? wanted : time_for(gap, 0.0, 1.0, speed);
  }
  const NearPart& part = *near;
  const double across = std::min(std::abs(velocity.dot(part.axis)), speed);
  const double along = std::sqrt(speed * speed - across * across);
  const Way ahead{way_in(wanted, across), way_in(wanted, along), whole};
  Found& found = scratch().ahead;
  found.clear();
  update_vertices(p, ahead, found);
  update_sides(p, ahead, found);
  part_due_[p] = next_visit(p);
  if (!part.due_vertices.empty()) return 0.0;
  const Way then = part.way + ahead;
  double time = wanted;
  if (list_end(part) < then.whole) {
    time = time_for(list_end(part) - part.way.whole, 0.0, 1.0, speed);
  }
  for (const Asleep* asleep : {&part.other_vertices, &part.all_features, &part.all_pairs}) {
    if (!asleep->due(then)) continue;
    time = std::min(time, time_for(asleep->left(part.way), asleep->per_across, asleep->per_along,
                                   asleep->per_across * across + asleep->per_along * along));
  }
  return time;
}

double ContactSearch::safe_time(const FlightBounds& flight, double worthwhile) {
  if (touches_ || moved_ < search_at_) return 0.0;
  const double ball = clear_time(ground_.grid,
                                 {.centre = tests_.position(),
                                  .velocity = flight.velocity,
                                  .gravity = flight.gravity,
                                  .radius = bounding_radius_ + reach_},
                                 kLongestFlight);
  if (ball >= kBallSteps * worthwhile) return ball;
  const double time = std::max(ball, flight_time(flight, kLongestFlight));
  if (time < worthwhile) search_at_ = moved_ + 0.5 * time * flight.top_speed;
  return time;
}

double ContactSearch::flight_time(const FlightBounds& flight, double horizon) {
  gather_ground(reach_ + kLastLook * margin_);
  const double known = ground_complete_ - (moved_ - ground_gathered_at_) - reach_;
  double time = std::min(horizon, time_over(known, flight.top_speed, flight.gravity));
  std::vector<std::uint32_t>& doubtful_parts = scratch().doubtful_parts;
  doubtful_parts.clear();
  // First the face that ended the last flight: with little time left most others need no close
  // look.
  const auto look_at = [&](std::uint32_t entry) {
    const double over = flight_time_over(local_.faces[entry], flight, time);
    if (over < time) lowest_face_ = entry;
    time = std::min(time, over);
  };
  const std::uint32_t first = lowest_face_;
  if (first < local_.faces.size()) look_at(first);
  for (std::uint32_t i = 0; i < local_.faces.size(); ++i) {
    if (i != first) look_at(i);
  }
  std::sort(doubtful_parts.begin(), doubtful_parts.end());
  const auto end = std::unique(doubtful_parts.begin(), doubtful_parts.end());
  for (auto p = doubtful_parts.begin(); p != end; ++p) {
    time = std::min(time, part_time(*p, flight, time));
  }
  return time;
}

double ContactSearch::flight_time_over(const LocalFaces::Face& face, const FlightBounds& flight,
                                       double horizon) {
  // The ball around the block, then those around its parts, and where they are too near the
  // vertices. A block whose vertices are all above a plane is above it.
  const Vec3& centre = tests_.position();
  const double height = face.normal.dot(centre) - face.offset - reach_;
  const Approach over(face.normal, flight);
  if (over.clear(height - bounding_radius_, Vec3::Zero(), 0.0, horizon)) return horizon;
  const bool at_border = is_at_border(ground_.features, face.face);
  const FlyingPart whole{centre, bounding_radius_, 0.0};
  if (!at_border && time_beside(face, whole, flight, horizon) >= horizon) return horizon;
  const Approach above = over.in_body(tests_.rotation());
  std::vector<std::uint32_t>& near_parts = scratch().near_parts;
  near_parts.clear();
  for (std::uint32_t p = 0; p < parts_.parts.size(); ++p) {
    const BlockPart& part = parts_.parts[p];
    const double apart = height + above.normal.dot(part.centre) - part.radius;
    if (!above.clear(apart, part.centre, flight.turning * part.arm, horizon)) {
      near_parts.push_back(p);
    }
  }
  double time = horizon;
  for (const std::uint32_t p : near_parts) {
    const BlockPart& part = parts_.parts[p];
    const double turning = flight.turning * (part.arm + part.radius);
    for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
      const Vec3& arm = block_.vertices[parts_.vertices[v]];
      const double apart = height + above.normal.dot(arm);
      if (apart < -kPlaneRounding) return parts_time_beside(face, at_border, flight, horizon);
      if (!above.clear(std::max(apart, 0.0), arm, turning, time)) {
        time = above.time(std::max(apart, 0.0), arm, turning);
      }
    }
  }
  return time;
}

double ContactSearch::parts_time_beside(const LocalFaces::Face& face, bool at_border,
                                        const FlightBounds& flight, double horizon) {
  double time = horizon;
  for (const std::uint32_t p : scratch().near_parts) {
    const BlockPart& part = parts_.parts[p];
    const FlyingPart ball{placed(part.centre), part.radius, flight.turning * part.arm};
    const double beside = at_border ? 0.0 : time_beside(face, ball, flight, time);
    if (beside > 0.0) {
      time = std::min(time, beside);
    } else {
      scratch().doubtful_parts.push_back(p);
    }
  }
  return time;
}

double ContactSearch::time_beside(const LocalFaces::Face& face, const FlyingPart& part,
                                  const FlightBounds& flight, double horizon) const {
  const Vec3 arm = part.centre - tests_.position();
  const double touching = part.radius + reach_;
  // From the ball around the face, or else from the plane that touches it nearest to the part.
  const Vec3 from_middle = part.centre - face.middle;
  const double far = from_middle.norm();
  if (far > face.radius + touching &&
      Approach(from_middle / far, flight)
          .clear(far - face.radius - touching, arm, part.turning, horizon)) {
    return horizon;
  }
  const NearestPoint nearest = foot_on_face(ground_.features, face.face, part.centre);
  const double distance = std::abs(nearest.distance), apart = distance - touching;
  if (!(apart > 0.0)) return 0.0;
  const Approach beside((part.centre - nearest.point) / distance, flight);
  return beside.clear(apart, arm, part.turning, horizon) ? horizon
                                                         : beside.time(apart, arm, part.turning);
}

}  // namespace clast::dem_detail
